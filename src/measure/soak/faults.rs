//! The faults of a soak: its report goes in, a sentence for each fault comes out.

use super::report::{Drift, Growth, Second, SoakReport};

/// Time in which the governor may look for its rung, seconds; in a short run at most this share of
/// it.
pub const SETTLING_SECONDS: f64 = 10.0;
const SETTLING_SHARE: f64 = 0.2;
/// How much further from the reference the frame at the end may be than that at the start, dB.
const MAX_DRIFT_DB: f64 = 0.05;
/// How close the frame at the end must be to that at the start, dB. It may differ: a GPU may blend
/// Gaussians of equal depth in another order.
const MIN_REDRAWN_DB: f64 = 50.0;

/// The limits that a soak must keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoakLimits {
    /// Share of the refreshes that may be without a new frame, 0 to 1.
    pub dropped: f64,
    /// Bytes that memory may grow by.
    pub growth: u64,
}

impl Default for SoakLimits {
    fn default() -> Self {
        Self {
            dropped: 0.01,
            growth: 1 << 20,
        }
    }
}

/// Share of the refreshes without a new frame, without the first seconds.
pub fn dropped_share(seconds: &[Second]) -> f64 {
    let end = seconds.last().map_or(0.0, |second| second.seconds);
    let settling = SETTLING_SECONDS.min(SETTLING_SHARE * end);
    let mut frames = 0;
    let mut dropped = 0;
    for second in seconds.iter().filter(|second| second.seconds > settling) {
        frames += u64::from(second.frames);
        dropped += u64::from(second.dropped);
    }
    if frames + dropped == 0 {
        0.0
    } else {
        dropped as f64 / (frames + dropped) as f64
    }
}

/// A sentence for each fault; none if the run kept its limits.
pub fn find_faults(report: &SoakReport, limits: &SoakLimits) -> Vec<String> {
    let mut faults = Vec::new();
    faults.extend(rate_fault(report, limits));
    if let Some(growth) = &report.growth {
        faults.extend(growth_faults(growth, limits));
    }
    if report.broken_pixels > 0 {
        faults.push(format!(
            "{} pixels of the {} images checked are NaN or infinite",
            report.broken_pixels, report.images
        ));
    }
    if let Some(broken) = report.broken_gaussians
        && broken > 0
    {
        faults.push(format!(
            "in one frame {broken} of {} Gaussians had a place or shape that is NaN or out of range of f32",
            report.avatar.gaussians
        ));
    }
    if report.empty_images > 0 {
        faults.push(format!(
            "{} of the {} images checked show nothing",
            report.empty_images, report.images
        ));
    }
    if let Some(drift) = &report.drift {
        faults.extend(drift_fault(drift));
    }
    if let Some(redrawn) = &report.redrawn
        && let Some(psnr_db) = redrawn.error.psnr_db
        && psnr_db < MIN_REDRAWN_DB
    {
        faults.push(format!(
            "the frame of the start, drawn again at the end, is {psnr_db:.2} dB from what it was: {MIN_REDRAWN_DB} dB is the limit"
        ));
    }
    faults
}

fn growth_faults(growth: &Growth, limits: &SoakLimits) -> Vec<String> {
    let mib = |bytes: i64| bytes as f64 / f64::from(1 << 20);
    let limit = limits.growth as i64;
    let gains = [
        ("the device's memory", Some(growth.device_bytes)),
        ("the process's memory", growth.resident_bytes),
    ];
    let mut faults = Vec::new();
    for (memory, gain) in gains {
        if let Some(gain) = gain
            && gain > limit
        {
            faults.push(format!(
                "{memory} grew by {:.2} MiB over {:.0} s of steady drawing, more than the {:.2} MiB allowed: something is not freed",
                mib(gain),
                growth.judged_seconds,
                mib(limit)
            ));
        }
    }
    faults
}

/// Whether the promised rate was held: few refreshes were without a new frame, and the governor did
/// not have to draw for every second refresh only.
pub fn held_rate(report: &SoakReport, limits: &SoakLimits) -> bool {
    let rung = report.ladder.get(report.lowest_rung);
    let halved = rung.is_some_and(|step| step.refreshes > 1);
    report.dropped_share <= limits.dropped && !halved
}

/// Whether the governor had nothing left to give up: a path of the ladder ends with it, or where
/// the next rung, the first of another path, has something back.
fn is_last(report: &SoakReport) -> bool {
    let from = |rung: usize| report.ladder.get(rung);
    let pair = from(report.lowest_rung).zip(from(report.lowest_rung + 1));
    pair.is_none_or(|(own, next)| next.scale > own.scale || next.refreshes < own.refreshes)
}

fn rate_fault(report: &SoakReport, limits: &SoakLimits) -> Option<String> {
    if held_rate(report, limits) {
        return None;
    }
    let rung = report.lowest_rung;
    let reason = if !report.governed {
        "the governor is off".to_owned()
    } else if is_last(report) {
        "the governor is at its last step".to_owned()
    } else {
        format!(
            "the governor went to step {rung}, where the device has time left: something else holds frames up"
        )
    };
    Some(format!(
        "{} frames a second were promised, {:.1} drawn, {:.2} % of the refreshes without a new one; {reason}",
        report.rate,
        report.fps,
        100.0 * report.dropped_share
    ))
}

fn drift_fault(drift: &Drift) -> Option<String> {
    let before = drift.before.psnr_db.unwrap_or(f64::INFINITY);
    let after = drift.after.psnr_db.unwrap_or(f64::INFINITY);
    (after < before - MAX_DRIFT_DB).then(|| {
        format!(
            "the image was {before:.2} dB from the reference at first and is {after:.2} dB from it now"
        )
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::report::{ErrorReport, tests as fixtures};
    use crate::soak::report::{RedrawnFrame, SCHEMA};
    use effigy_runtime::governor::Ladder;

    /// A faultless minute at 60 frames a second.
    pub(crate) fn report() -> SoakReport {
        let second = |at: usize| Second {
            seconds: at as f64,
            frames: 60,
            fps: 60.0,
            headroom: Some(at as f64 / 60.0),
            ..Second::default()
        };
        let error = ErrorReport {
            psnr_db: Some(50.0),
            ..ErrorReport::NONE
        };
        SoakReport {
            schema: SCHEMA.to_owned(),
            program: fixtures::part("program"),
            device: fixtures::part("device"),
            avatar: fixtures::part("avatar"),
            size: [640, 480],
            options: fixtures::part("options"),
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
            growth: Some(Growth {
                from_seconds: 24.0,
                judged_seconds: 36.0,
                device_bytes: 0,
                resident_bytes: Some(4096),
            }),
            images: 60,
            broken_pixels: 0,
            empty_images: 0,
            broken_gaussians: Some(0),
            drift: Some(Drift {
                before: error,
                after: error,
                same: true,
            }),
            redrawn: None,
            faults: vec![],
            each: (1..=60).map(second).collect(),
        }
    }

    /// The faults of that minute after a change to its report.
    fn faults_after(change: impl Fn(&mut SoakReport)) -> String {
        let mut report = report();
        change(&mut report);
        find_faults(&report, &SoakLimits::default()).join("\n")
    }

    #[test]
    fn every_fault_is_named() {
        assert_eq!(faults_after(|_| ()), "");
        assert!(faults_after(|r| r.broken_pixels = 3).contains("3 pixels of the 60 images"));
        assert!(faults_after(|r| r.empty_images = 1).contains("show nothing"));
        assert!(faults_after(|r| r.broken_gaussians = Some(2)).contains("2 of 200000 Gaussians"));
        let grown = faults_after(|r| {
            if let Some(growth) = &mut r.growth {
                growth.resident_bytes = Some(3 << 20);
            }
        });
        assert!(
            grown.contains("the process's memory grew by 3.00 MiB"),
            "{grown}"
        );
        let drifted = faults_after(|r| {
            if let Some(drift) = &mut r.drift {
                drift.after.psnr_db = Some(48.0);
            }
        });
        assert!(
            drifted.contains("50.00 dB from the reference at first and is 48.00"),
            "{drifted}"
        );
    }

    #[test]
    fn a_missed_rate_is_explained() {
        let late = faults_after(|r| r.dropped_share = 0.02);
        assert!(late.contains("something else holds frames up"), "{late}");
        let ungoverned = faults_after(|r| {
            r.dropped_share = 0.02;
            r.governed = false;
        });
        assert!(ungoverned.contains("the governor is off"), "{ungoverned}");
        let exhausted = faults_after(|r| {
            r.dropped_share = 0.02;
            r.lowest_rung = r.ladder.len() - 1;
        });
        assert!(exhausted.contains("last step"), "{exhausted}");
        let halved = faults_after(|r| r.lowest_rung = r.ladder.len() - 1);
        assert!(
            halved.contains("last step"),
            "half the rate is not the rate: {halved}"
        );
    }

    #[test]
    fn a_redrawn_frame_must_be_close() {
        let after = |error: ErrorReport| {
            faults_after(|r| {
                r.redrawn = Some(RedrawnFrame {
                    size: r.size,
                    same: false,
                    error,
                })
            })
        };
        let far = ErrorReport {
            psnr_db: Some(40.0),
            ..ErrorReport::NONE
        };
        assert!(after(far).contains("40.00 dB from what it was"));
        assert_eq!(after(ErrorReport::NONE), "");
    }

    #[test]
    fn the_first_seconds_are_not_judged() {
        let mut seconds = report().each;
        seconds[0].dropped = 100;
        seconds[5].dropped = 100;
        assert_eq!(dropped_share(&seconds), 0.0);
        seconds[30].dropped = 60;
        let expected = 60.0 / (50.0 * 60.0 + 60.0);
        assert!((dropped_share(&seconds) - expected).abs() < 1e-12);
    }
}
