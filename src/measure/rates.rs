//! What a device manages in a second, measured: bytes that it copies and fragments that it fills an
//! image with. [`measure_rates`] makes a [`RatesReport`], whose fields are the keys of the JSON.

use crate::report::{DeviceReport, Program};
use effigy_render::vulkan::{
    Gpu, Result, RunTimes,
    raster::ColorFormat,
    rates::{Copy, CopyMethod, Fill, FillOrder, FillShape, Filling, MOST_LAYERS},
};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeSet, sync::Arc, time::Duration};

/// Version of the JSON. It changes whenever an older program could misread a newer file.
pub const SCHEMA: &str = "effigy-rates-1";

/// Times that everything is measured; the median counts.
const RUNS: usize = 5;
/// Bytes of the copies, smallest first. The first is as good as none: its time is that of a
/// dispatch that waits for the one before.
const COPIES: [u64; 6] = [16, 64 << 10, 1 << 20, 8 << 20, 64 << 20, 256 << 20];
/// Most copies of one measurement.
const MOST_COPIES: u32 = 1 << 12;
/// Fewest layers of one measurement, so that clearing and storing the image hardly count.
const FEWEST_LAYERS: u32 = 8;
/// Opacity of a blended layer, or of a Gaussian at its centre.
const OPACITY: f32 = 0.25;

/// The rates of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RatesReport {
    /// [`SCHEMA`].
    pub schema: String,
    /// The program that measured.
    pub program: Program,
    /// The device that was measured.
    pub device: DeviceReport,
    /// Copies from buffer to buffer.
    pub copies: Vec<CopyReport>,
    /// Width and height of the image that was filled, px.
    pub fill_size: [u32; 2],
    /// Layers over the whole image.
    pub fills: Vec<FillReport>,
}

impl RatesReport {
    /// Bytes a second of the fastest method at the largest size, read and written: those of memory,
    /// not of caches.
    pub fn memory_bandwidth(&self) -> Option<f64> {
        let largest = self.copies.iter().map(|copy| copy.bytes).max()?;
        let of_largest = self.copies.iter().filter(|copy| copy.bytes == largest);
        of_largest.map(|copy| copy.bytes_a_second).reduce(f64::max)
    }

    /// Bytes a second of the kernel at the largest size that is not above `bytes`, read and
    /// written. A stage that moves so much may find it in caches. None where no copy is within a
    /// factor of 8: a smaller one takes the time of a dispatch, not of its bytes.
    pub fn bandwidth_at(&self, bytes: u64) -> Option<f64> {
        let by_kernel = self.copies.iter().filter(|copy| {
            copy.method == CopyMethod::Kernel.name()
                && 2 * copy.bytes <= bytes
                && 16 * copy.bytes > bytes
        });
        let largest = by_kernel.max_by_key(|copy| copy.bytes)?;
        Some(largest.bytes_a_second)
    }
}

/// Copies of one size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CopyReport {
    /// Bytes that a copy reads, and as many that it writes.
    pub bytes: u64,
    /// `kernel` or `transfer`.
    pub method: String,
    /// Copies of one measurement, each of which waits for the one before.
    pub times: u32,
    /// Time of one copy, µs.
    pub us: f64,
    /// Bytes read and written in a second.
    pub bytes_a_second: f64,
    /// Whether the copy was the same as the original.
    pub right: bool,
}

/// Layers of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FillReport {
    /// Format of the image: `rgba8` or `rgba16f`.
    pub color: String,
    /// Whether layers are blended; if not they are opaque, and tested against the depth.
    pub blended: bool,
    /// `back to front` or `front to back`.
    pub order: String,
    /// `whole`, `quads` of 16 px, or `gaussians` in such quads.
    pub shape: String,
    /// Layers of one measurement.
    pub layers: u32,
    /// Time of a layer, µs.
    pub us: f64,
    /// Fragments a second: those of the layers, whether the depth test rejects them or not.
    pub fragments_a_second: f64,
}

/// What is measured, and for how long.
#[derive(Clone, Copy, Debug)]
pub struct RatesSettings {
    /// Width and height of the image that is filled, px.
    pub size: [u32; 2],
    /// Least time of one run, if the device manages more.
    pub least: Duration,
    /// Largest copy, bytes.
    pub largest: u64,
}

/// The kinds of layers that are measured of each format.
const FILLINGS: [Filling; 6] = {
    let whole = Filling {
        format: ColorFormat::Rgba8,
        blended: false,
        order: FillOrder::BackToFront,
        shape: FillShape::Whole,
    };
    let blended = Filling {
        blended: true,
        ..whole
    };
    [
        whole,
        Filling {
            order: FillOrder::FrontToBack,
            ..whole
        },
        blended,
        Filling {
            order: FillOrder::FrontToBack,
            ..blended
        },
        Filling {
            shape: FillShape::Quads,
            ..blended
        },
        Filling {
            shape: FillShape::Gaussians,
            ..blended
        },
    ]
};

/// Measures all rates of a device. `show` hears of each when it begins, and how many of how many
/// are done; `keep` gets what is measured so far after each, and says whether to go on. No image is
/// filled where the driver can't draw triangles.
///
/// # Errors
/// When the device fails.
pub fn measure_rates(
    gpu: &Arc<Gpu>,
    settings: &RatesSettings,
    command: Vec<String>,
    show: &mut dyn FnMut(&str, usize, usize),
    keep: &mut dyn FnMut(&RatesReport) -> bool,
) -> Result<RatesReport> {
    let limit = u64::from(gpu.probe.limits.max_storage_buffer_range);
    let mut report = RatesReport {
        schema: SCHEMA.to_owned(),
        program: Program::current(command),
        device: DeviceReport::from_vulkan(gpu),
        copies: Vec::new(),
        fill_size: settings.size,
        fills: Vec::new(),
    };
    let copies: BTreeSet<u64> = COPIES
        .map(|bytes| bytes.min(settings.largest).min(limit))
        .into();
    let fillings = [ColorFormat::Rgba8, ColorFormat::Rgba16F]
        .map(|format| FILLINGS.map(|filling| Filling { format, ..filling }));
    let fillings = fillings.as_flattened().iter();
    let fillings: Vec<&Filling> = fillings.filter(|_| gpu.probe.draws_triangles()).collect();
    let all = copies.len() + fillings.len();
    for (done, bytes) in copies.iter().copied().enumerate() {
        show(&format!("copies of {bytes} bytes"), done, all);
        let measured = measure_copies(gpu, bytes, settings.least)?;
        report.copies.extend(measured);
        if !keep(&report) {
            return Ok(report);
        }
    }
    for (done, filling) in fillings.into_iter().enumerate() {
        let mut show = |what: &str| show(what, copies.len() + done, all);
        let measured = measure_fill(gpu, *filling, settings, &mut show)?;
        report.fills.push(measured);
        if !keep(&report) {
            break;
        }
    }
    Ok(report)
}

fn measure_copies(gpu: &Arc<Gpu>, bytes: u64, least: Duration) -> Result<Vec<CopyReport>> {
    let mut reports = Vec::new();
    for method in CopyMethod::ALL {
        let copy = Copy::new(gpu, bytes)?;
        copy.load()?;
        copy.time(method, 1)?;
        let right = copy.is_copied()?;
        let measured = median_of(1, MOST_COPIES, least, |times| copy.time(method, times))?;
        let us = measured.each.as_secs_f64() * 1e6;
        reports.push(CopyReport {
            bytes: copy.bytes(),
            method: method.name().to_owned(),
            times: measured.times,
            us,
            bytes_a_second: a_second(2.0 * copy.bytes() as f64, us),
            right,
        });
    }
    Ok(reports)
}

fn measure_fill(
    gpu: &Arc<Gpu>,
    filling: Filling,
    settings: &RatesSettings,
    show: &mut dyn FnMut(&str),
) -> Result<FillReport> {
    let mut report = FillReport {
        color: filling.format.name().to_owned(),
        blended: filling.blended,
        order: match filling.order {
            FillOrder::BackToFront => "back to front",
            FillOrder::FrontToBack => "front to back",
        }
        .to_owned(),
        shape: match filling.shape {
            FillShape::Whole => "whole",
            FillShape::Quads => "quads",
            FillShape::Gaussians => "gaussians",
        }
        .to_owned(),
        layers: 0,
        us: 0.0,
        fragments_a_second: 0.0,
    };
    show(&report.title());
    let fill = Fill::new(gpu, filling, settings.size, OPACITY)?;
    let time = |layers| fill.time(layers);
    let measured = median_of(FEWEST_LAYERS, MOST_LAYERS, settings.least, time)?;
    let pixels = settings.size.map(f64::from);
    report.layers = measured.times;
    report.us = measured.each.as_secs_f64() * 1e6;
    report.fragments_a_second = a_second(pixels[0] * pixels[1], report.us);
    Ok(report)
}

impl FillReport {
    /// What was drawn, in words.
    pub fn title(&self) -> String {
        let how = if self.blended { "blended" } else { "opaque" };
        format!("{} {how} {}, {}", self.color, self.order, self.shape)
    }
}

/// How often something happens a second that takes so many µs for `count`.
fn a_second(count: f64, us: f64) -> f64 {
    if us > 0.0 { count / us * 1e6 } else { 0.0 }
}

/// The mean time of one repetition, and how many there were.
struct MeanTime {
    times: u32,
    each: Duration,
}

/// Finds how many things take as long as `least`, from `fewest` to `most`, and measures them.
/// `run` does so many of them.
fn median_of(
    fewest: u32,
    most: u32,
    least: Duration,
    run: impl Fn(u32) -> Result<RunTimes>,
) -> Result<MeanTime> {
    let mut times = fewest;
    // The first run pays for what is made late.
    run(times)?;
    loop {
        let took = run(times)?.device;
        if took >= least || times == most {
            break;
        }
        // A time of nothing is one that the clock does not resolve.
        let missing = least.as_secs_f64() / took.as_secs_f64().max(1e-9);
        let grown = f64::from(times) * missing.clamp(2.0, 8.0);
        times = (grown as u32).min(most);
    }
    let mut all = (0..RUNS)
        .map(|_| Ok(run(times)?.device))
        .collect::<Result<Vec<_>>>()?;
    all.sort_unstable();
    Ok(MeanTime {
        times,
        each: all[RUNS / 2] / times,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    fn copy(bytes: u64, method: CopyMethod, rate: f64) -> CopyReport {
        CopyReport {
            bytes,
            method: method.name().to_owned(),
            times: 1,
            us: 1.0,
            bytes_a_second: rate,
            right: true,
        }
    }

    fn report(copies: Vec<CopyReport>) -> RatesReport {
        RatesReport {
            schema: SCHEMA.into(),
            program: Program::current(Vec::new()),
            device: DeviceReport {
                name: "A".into(),
                driver: "B".into(),
                vulkan: "1.3.0".into(),
                subgroup_size: 8,
                timestamps: true,
                backend: "vulkan".into(),
            },
            copies,
            fill_size: [4, 4],
            fills: Vec::new(),
        }
    }

    #[test]
    fn bandwidth_is_that_of_the_size() {
        let rates = report(vec![
            copy(100, CopyMethod::Kernel, 9.0),
            copy(100, CopyMethod::Transfer, 20.0),
            copy(1000, CopyMethod::Kernel, 5.0),
            copy(1000, CopyMethod::Transfer, 6.0),
        ]);
        assert_eq!(rates.memory_bandwidth(), Some(6.0));
        assert_eq!(rates.bandwidth_at(1500), Some(9.0));
        assert_eq!(rates.bandwidth_at(1999), None);
        assert_eq!(rates.bandwidth_at(2000), Some(5.0));
        assert_eq!(rates.bandwidth_at(10), None);
        assert_eq!(report(Vec::new()).memory_bandwidth(), None);
    }

    #[test]
    fn what_is_short_is_done_more_often() {
        let asked = RefCell::new(Vec::new());
        let measured = median_of(8, 4096, Duration::from_millis(10), |times| {
            asked.borrow_mut().push(times);
            let device = Duration::from_micros(u64::from(times));
            Ok(RunTimes {
                device,
                wall: device,
            })
        });
        let measured = measured.expect("nothing fails");
        assert_eq!(measured.each, Duration::from_micros(1));
        assert_eq!(measured.times, 4096, "{:?}", asked.borrow());
        let long = median_of(8, 4096, Duration::from_millis(10), |_| {
            Ok(RunTimes {
                device: Duration::from_secs(1),
                wall: Duration::from_secs(1),
            })
        });
        assert_eq!(long.expect("nothing fails").times, 8);
    }
}
