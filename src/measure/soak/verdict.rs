//! What is wrong with a soak: its report goes in, a sentence for every fault comes out.

use super::report::{Drift, Report, Second};

/// Until here the governor may look for its rung: seconds, and of a short run this share of it.
pub const SETTLED: (f64, f64) = (10.0, 0.2);
/// A picture may be as much worse than the first, dB.
const DRIFT: f64 = 0.05;
/// A picture must be as near the first, dB: a GPU may blend what is equally far away in another order.
const STILL: f64 = 50.0;

/// What a soak must keep within.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Share of the refreshes that may show nothing new.
    pub dropped: f64,
    /// Bytes that memory may grow by.
    pub growth: u64,
}

impl Default for Bounds {
    fn default() -> Self {
        Self { dropped: 0.01, growth: 1 << 20 }
    }
}

/// Share of the refreshes that showed nothing new, once it had settled.
pub fn dropped_share(each: &[Second]) -> f64 {
    let end = each.last().map_or(0.0, |second| second.seconds);
    let settled = SETTLED.0.min(SETTLED.1 * end);
    let judged = each.iter().filter(|second| second.seconds > settled);
    let (frames, dropped) = judged.fold((0u64, 0u64), |(f, d), second| (f + u64::from(second.frames), d + u64::from(second.dropped)));
    if frames + dropped == 0 { 0.0 } else { dropped as f64 / (frames + dropped) as f64 }
}

/// Every fault; none where the run held what was promised.
pub fn faults(report: &Report, bounds: &Bounds) -> Vec<String> {
    let mut faults = Vec::new();
    faults.extend(rate(report, bounds));
    let mib = |bytes: i64| bytes as f64 / f64::from(1 << 20);
    if let Some(growth) = &report.growth {
        let all = [("the device's memory", Some(growth.device_bytes)), ("the process's memory", growth.resident_bytes)];
        for (what, gained) in all.into_iter().filter_map(|(what, gained)| Some((what, gained?))) {
            if gained > bounds.growth as i64 {
                let (gained, bound, judged) = (mib(gained), mib(bounds.growth as i64), growth.judged_seconds);
                faults.push(format!(
                    "{what} grew by {gained:.2} MiB in the {judged:.0} s that are judged, more than the {bound:.2} MiB allowed: something is not freed"
                ));
            }
        }
    }
    if report.broken_pixels > 0 {
        faults.push(format!("{} pixels of the {} pictures looked at are NaN or infinite", report.broken_pixels, report.pictures));
    }
    if let Some(broken) = report.broken_gaussians.filter(|&broken| broken > 0) {
        let all = report.avatar.gaussians;
        faults
            .push(format!("{broken} of {all} Gaussians had a place or shape that is no number, or beyond what f32 can tell, in one frame"));
    }
    if report.empty_pictures > 0 {
        faults.push(format!("{} of the {} pictures looked at show nothing", report.empty_pictures, report.pictures));
    }
    faults.extend(report.drift.as_ref().and_then(drift));
    let still = report.still.and_then(|still| still.error.psnr_db).filter(|&db| db < STILL);
    faults.extend(
        still.map(|db| format!("the frame of the start, drawn again at the end, is {db:.2} dB from what it was: {STILL} dB are allowed")),
    );
    faults
}

fn rate(report: &Report, bounds: &Bounds) -> Option<String> {
    let lowest = report.ladder.len().saturating_sub(1);
    let halved = report.ladder.get(report.lowest_rung).is_some_and(|step| step.refreshes > 1);
    if report.dropped_share <= bounds.dropped && !halved {
        return None;
    }
    let (promised, share) = (report.rate, 100.0 * report.dropped_share);
    let found =
        format!("{promised} frames a second were promised, {:.1} drawn, {share:.2} % of the refreshes without a new one", report.fps);
    let why = match report.lowest_rung {
        _ if !report.governed => "the governor is off: turn it on, or promise less with --fps".to_owned(),
        rung if rung >= lowest => "the governor is at its last step: promise less with --fps, or draw less".to_owned(),
        rung => {
            format!("the governor went to step {rung} of {lowest}, where the device has time left: something else holds frames up")
        }
    };
    Some(format!("{found}; {why}"))
}

fn drift(drift: &Drift) -> Option<String> {
    let [before, after] = [&drift.before, &drift.after].map(|error| error.psnr_db.unwrap_or(f64::INFINITY));
    (after < before - DRIFT).then(|| format!("the picture was {before:.2} dB from the reference at first and is {after:.2} dB from it now"))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::measure::{
        bench::report::{Device, ErrorReport, Options, Program, Subject},
        governor::Ladder,
        soak::report::{Growth, SCHEMA, Still},
    };

    /// A run of a minute at 60 frames a second that is all right.
    pub(in crate::measure::soak) fn report() -> Report {
        let text = |text: &str| text.to_owned();
        let second =
            |at: usize| Second { seconds: at as f64, frames: 60, fps: 60.0, headroom: Some(at as f64 / 60.0), ..Second::default() };
        Report {
            schema: text(SCHEMA),
            program: Program { version: text("1"), commit: None, date: text("now"), command: vec![] },
            device: Device {
                name: text("A"),
                driver: text("B"),
                vulkan: text("1.3.0"),
                half_storage: true,
                subgroup_size: 8,
                timestamps: true,
                backend: "vulkan".into(),
            },
            avatar: Subject { name: text("body"), clip: text("walk"), gaussians: 10, parts: 1, nodes: 2, rows: [1, 2, 3] },
            size: [640, 480],
            options: Options {
                color: text("rgba8"),
                raster: text("tiles"),
                key_bits: 16,
                skip: text("none"),
                cutoff: 1.0 / 255.0,
                margin: 0.005,
                detail: text("full"),
                storage: text("half"),
                rows: 1.0,
                hold: 1,
            },
            rate: 60.0,
            governed: true,
            simulated_heat: false,
            planned_seconds: 60.0,
            lasted_seconds: 60.0,
            ladder: Ladder::new(60.0).rungs().iter().map(Into::into).collect(),
            frames: 3600,
            fps: 60.0,
            late: 0,
            dropped: 0,
            dropped_share: 0.0,
            changes: 0,
            lowest_rung: 0,
            growth: Some(Growth { from_seconds: 24.0, judged_seconds: 36.0, device_bytes: 0, resident_bytes: Some(4096) }),
            pictures: 60,
            broken_pixels: 0,
            empty_pictures: 0,
            broken_gaussians: Some(0),
            drift: Some(Drift {
                before: ErrorReport { psnr_db: Some(50.0), ..ErrorReport::NONE },
                after: ErrorReport { psnr_db: Some(50.0), ..ErrorReport::NONE },
                same: true,
            }),
            still: None,
            faults: vec![],
            each: (1..=60).map(second).collect(),
        }
    }

    fn told(change: impl Fn(&mut Report)) -> String {
        let mut changed = report();
        change(&mut changed);
        faults(&changed, &Bounds::default()).join("\n")
    }

    #[test]
    fn every_fault_is_told_with_what_to_do() {
        assert_eq!(told(|_| ()), "");
        assert!(told(|r| r.broken_pixels = 3).contains("3 pixels of the 60 pictures"));
        assert!(told(|r| r.empty_pictures = 1).contains("show nothing"));
        assert!(told(|r| r.broken_gaussians = Some(2)).contains("2 of 10 Gaussians"));
        let grown = |r: &mut Report| {
            r.growth = Some(Growth { from_seconds: 60.0, judged_seconds: 1.0, device_bytes: 0, resident_bytes: Some(3 << 20) })
        };
        assert!(told(grown).contains("the process's memory grew by 3.00 MiB"));
        assert!(told(|r| r.dropped_share = 0.02).contains("something else holds frames up"));
        assert!(told(|r| (r.dropped_share, r.governed) = (0.02, false)).contains("the governor is off"));
        assert!(told(|r| (r.dropped_share, r.lowest_rung) = (0.02, r.ladder.len() - 1)).contains("last step"));
        assert!(told(|r| r.lowest_rung = r.ladder.len() - 1).contains("last step"), "half the rate is not the rate");
        let drifted =
            |r: &mut Report| r.drift = r.drift.map(|drift| Drift { after: ErrorReport { psnr_db: Some(48.0), ..drift.after }, ..drift });
        let error = ErrorReport { psnr_db: Some(40.0), ..ErrorReport::NONE };
        assert!(told(|r| r.still = Some(Still { size: r.size, same: false, error })).contains("40.00 dB from what it was"));
        assert_eq!(told(|r| r.still = Some(Still { size: r.size, same: true, error: ErrorReport::NONE })), "");
        assert!(told(drifted).contains("50.00 dB from the reference at first and is 48.00"));
    }

    #[test]
    fn the_first_seconds_are_not_judged() {
        let mut each = report().each;
        (each[0].dropped, each[5].dropped) = (100, 100);
        assert_eq!(dropped_share(&each), 0.0);
        each[30].dropped = 60;
        assert!((dropped_share(&each) - 60.0 / (50.0 * 60.0 + 60.0)).abs() < 1e-12);
    }
}
