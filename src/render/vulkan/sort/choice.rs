//! The self-test: sorts adversarial keys with each variant that a device can run, compares with the
//! CPU, times those that are right, and picks the fastest. Drivers exist that give wrong orders
//! without a word, and no query tells.

use super::{
    options::{SortOptions, unsupported},
    standalone::StandaloneSort,
};
use crate::vulkan::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        trial::{Record, SortChoice, TrialOutcome, Tried},
    },
    pipeline::shaders,
};
use effigy_core::{
    frame::{KeyBits, SortVariant},
    layout::{MAX_SUMMED_TILES, SORT_CULLED},
};
use std::{
    path::Path,
    sync::{Arc, PoisonError},
    time::Duration,
};

/// Keys of the largest test: enough for every variant to have many tiles.
const KEYS: u32 = 60_000;
/// Runs of which the best counts.
const TIMED: usize = 3;
/// Tiles of the test of long keys: so many that the scans add them up in groups.
const LONG_TILES: u32 = MAX_SUMMED_TILES + 3;
/// A sort of so few keys that takes longer, twice, is refused.
const PATIENCE: Duration = Duration::from_secs(2);

/// The variants for a device, of which the first is the safest: without a test it may be used.
fn variants(gpu: &Gpu) -> [SortVariant; 2] {
    // Counters for each thread save a CPU driver its barriers; OneSweep takes one a second and more
    // to compile, and gains it nothing.
    if gpu.probe.is_cpu() {
        [SortVariant::PerThread, SortVariant::ReduceThenScan]
    } else {
        [SortVariant::ReduceThenScan, SortVariant::OneSweep]
    }
}

fn record(gpu: &Gpu, folder: Option<&Path>) -> Record<SortVariant> {
    Record::new(gpu, folder, "sort", shaders::sort_hash())
}

/// Returns the variant to sort with, testing those without a record. The first call after a change
/// of driver or program takes a part of a second; later calls and starts read the record. Fails
/// where no variant is right, or the device is lost or hangs in a test, which later starts do not
/// repeat.
pub fn choose(gpu: &Arc<Gpu>) -> Result<SortChoice> {
    if let Some(choice) = gpu.sorts.chosen.get() {
        return Ok(choice.clone());
    }
    let choice = choose_in(gpu, gpu.cache_folder())?;
    Ok(gpu.sorts.chosen.get_or_init(|| choice).clone())
}

/// The variant to draw the first frame with: the fastest that earlier tests found right, else one
/// that needs neither subgroups nor look-back. Nothing is tested, so that nobody waits for it;
/// [`choose`] tests. Fails where every variant was tested and none is right.
pub fn without_test(gpu: &Gpu) -> Result<SortVariant> {
    if let Some(choice) = gpu.sorts.chosen.get() {
        return Ok(choice.variant);
    }
    let record = record(gpu, gpu.cache_folder());
    // Read each time: a test behind a window may have found something since.
    let tried = record.read();
    if let Some(choice) = chosen(gpu, &tried) {
        return Ok(choice.variant);
    }
    let mut untried = untried(gpu, &tried).into_iter();
    untried.next().ok_or_else(|| no_sort(gpu, &tried, &record))
}

/// The fastest variant that is right. Where every trial was ended, by whoever kills programs, the
/// safest is drawn with all the same: nothing else is known of it.
fn chosen(gpu: &Gpu, tried: &[Tried<SortVariant>]) -> Option<SortChoice> {
    let [safest, _] = variants(gpu);
    let is_unknown = Tried::outcome_of(tried, safest) == Some(&TrialOutcome::Unfinished);
    let all_tried = untried(gpu, tried).is_empty();
    SortChoice::fastest(tried).or_else(|| {
        (is_unknown && all_tried).then(|| SortChoice {
            variant: safest,
            tried: tried.to_vec(),
        })
    })
}

/// The variants without a record, the safest first.
fn untried(gpu: &Gpu, tried: &[Tried<SortVariant>]) -> Vec<SortVariant> {
    variants(gpu)
        .into_iter()
        .filter(|variant| Tried::outcome_of(tried, *variant).is_none())
        .collect()
}

/// Whether every variant has a record, so that [`choose`] tests nothing.
pub fn is_tested(gpu: &Gpu) -> bool {
    gpu.sorts.chosen.get().is_some() || {
        let record = record(gpu, gpu.cache_folder());
        untried(gpu, &record.read()).is_empty()
    }
}

/// Like [`choose`], with the record in `folder`; None keeps no record.
pub fn choose_in(gpu: &Arc<Gpu>, folder: Option<&Path>) -> Result<SortChoice> {
    let record = record(gpu, folder);
    let mut tried = record.read();
    let untried = untried(gpu, &tried);
    for &variant in &untried {
        record.begin(&tried, variant);
        match test(gpu, variant) {
            Ok(outcome) => tried.push(Tried { variant, outcome }),
            Err(error) => {
                if brought_down(gpu, &error) {
                    tried.push(Tried {
                        variant,
                        outcome: TrialOutcome::Refused(error.to_string()),
                    });
                }
                record.write(&tried);
                return Err(error);
            }
        }
    }
    if !untried.is_empty() {
        record.write(&tried);
    }
    chosen(gpu, &tried).ok_or_else(|| no_sort(gpu, &tried, &record))
}

fn no_sort(gpu: &Gpu, tried: &[Tried<SortVariant>], record: &Record<SortVariant>) -> Error {
    let reasons: Vec<_> = tried
        .iter()
        .map(|tested| format!("{}: {}", tested.variant.name(), tested.outcome))
        .collect();
    Error::NoSort {
        device: gpu.probe.name.clone(),
        reasons: reasons.join("; "),
        record: record.path().map(Path::to_path_buf),
    }
}

/// Whether a failed test refuses the variant for good: yes where the test lost or hung the device.
/// Too little memory or, on a CPU, a timeout may not happen next time.
fn brought_down(gpu: &Gpu, error: &Error) -> bool {
    match error {
        Error::OutOfMemory { .. } => false,
        Error::Timeout { .. } => !gpu.probe.is_cpu(),
        _ => true,
    }
}

/// The variant to sort with: the one that the user named, which is tested if it has no record, or
/// [`without_test`].
pub(crate) fn allowed(gpu: &Arc<Gpu>, named: Option<SortVariant>) -> Result<SortVariant> {
    let Some(variant) = named else {
        return without_test(gpu);
    };
    allow(gpu, variant)?;
    Ok(variant)
}

/// Checks that a variant named by the user may be used. Tests it if it has no record.
fn allow(gpu: &Arc<Gpu>, variant: SortVariant) -> Result<()> {
    if gpu.statistics.is_some() {
        // Programs that ask for shader statistics may have no device that runs the shaders.
        return Ok(());
    }
    let why = match outcome_of(gpu, variant)? {
        TrialOutcome::Right(_) => return Ok(()),
        TrialOutcome::Unsupported(why) => why,
        outcome => format!("its test says {outcome}"),
    };
    Err(Error::Unsupported {
        device: gpu.probe.name.clone(),
        missing: format!("for {}: {why}", variant.name()),
    })
}

/// The outcome of a variant named by the user. Tests it if it has no record.
fn outcome_of(gpu: &Arc<Gpu>, variant: SortVariant) -> Result<TrialOutcome> {
    let find = |tried: &[Tried<SortVariant>]| Tried::outcome_of(tried, variant).cloned();
    let mut asked = gpu
        .sorts
        .asked
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    if let Some(outcome) = find(&asked) {
        return Ok(outcome);
    }
    let known = match gpu.sorts.chosen.get() {
        Some(choice) => find(&choice.tried),
        None => find(&record(gpu, gpu.cache_folder()).read()),
    };
    match known {
        // It may lack no more than a use here.
        Some(TrialOutcome::Unsupported(_)) | None => {
            let outcome = test(gpu, variant)?;
            asked.push(Tried {
                variant,
                outcome: outcome.clone(),
            });
            Ok(outcome)
        }
        Some(outcome) => Ok(outcome),
    }
}

/// Tests one variant, whatever the record says. Fails only where the device can't be used any more.
pub fn test(gpu: &Arc<Gpu>, variant: SortVariant) -> Result<TrialOutcome> {
    if let Some(reason) = unsupported(variant, gpu) {
        return Ok(TrialOutcome::Unsupported(reason.into()));
    }
    match run(gpu, variant) {
        Ok(outcome) => Ok(outcome),
        Err(error @ (Error::Timeout { .. } | Error::DeviceLost(_) | Error::OutOfMemory { .. })) => {
            Err(error)
        }
        Err(error) => Ok(TrialOutcome::Refused(error.to_string())),
    }
}

fn run(gpu: &Arc<Gpu>, variant: SortVariant) -> Result<TrialOutcome> {
    let sorter = StandaloneSort::new(gpu, KEYS, SortOptions::new(KeyBits::Sixteen, variant))?;
    // Drivers may compile in the first run, which is therefore not held against the variant.
    sorter.load(&[7])?;
    sorter.run()?;
    for (name, keys) in adversarial(variant.tile()) {
        sorter.load(&keys)?;
        let mut times = sorter.run()?;
        if let Some(difference) = sorter.difference(&keys)? {
            return Ok(TrialOutcome::Refused(format!(
                "wrong for {name}: {difference}"
            )));
        }
        if times.wall > PATIENCE {
            // The machine may have been busy, or asleep.
            times = sorter.run()?;
        }
        if times.wall > PATIENCE {
            return Ok(TrialOutcome::Refused(format!(
                "{:.1} s for {name}",
                times.wall.as_secs_f64()
            )));
        }
    }
    // The largest keys are still loaded: depths of a body have about that many different values.
    let mut best = Duration::MAX;
    let (_, keys) = spread();
    for _ in 0..TIMED {
        best = best.min(sorter.run()?.device);
        if let Some(difference) = sorter.difference(&keys)? {
            return Ok(TrialOutcome::Refused(format!(
                "wrong when repeated: {difference}"
            )));
        }
    }
    Ok(match long(gpu, variant)? {
        Some(difference) => {
            TrialOutcome::Refused(format!("wrong for keys of 32 bits: {difference}"))
        }
        None => TrialOutcome::Right(best.as_secs_f64() * 1e3),
    })
}

/// Tests a sort of so many long keys that every kernel has its part: pairs, all four passes, sums
/// of sums. Returns what is wrong with it, if anything.
fn long(gpu: &Arc<Gpu>, variant: SortVariant) -> Result<Option<String>> {
    let count = LONG_TILES * variant.tile();
    let sorter = StandaloneSort::new(gpu, count, SortOptions::new(KeyBits::ThirtyTwo, variant))?;
    let keys: Vec<u32> = (0..count)
        .map(|at| at.wrapping_mul(2_654_435_769))
        .collect();
    sorter.load(&keys)?;
    sorter.run()?;
    sorter.difference(&keys)
}

/// Keys, and what they are called in messages.
type NamedKeys = (&'static str, Vec<u32>);

/// Keys without pattern (Knuth's multiplicative hash).
fn scramble(at: u32) -> u32 {
    at.wrapping_mul(2_654_435_769) >> 16
}

fn spread() -> NamedKeys {
    ("spread keys", (0..KEYS).map(scramble).collect())
}

/// Sets of keys that are likely to show an error, the largest last.
fn adversarial(tile: u32) -> Vec<NamedKeys> {
    let drop = |at: u32, key: u32| {
        if scramble(at ^ 0x5555).is_multiple_of(3) {
            SORT_CULLED
        } else {
            key
        }
    };
    let several = 3 * tile;
    vec![
        ("one key", vec![7]),
        ("culled keys only", vec![SORT_CULLED; 1000]),
        ("a tile less one", (0..tile - 1).map(scramble).collect()),
        ("a tile and one", (0..=tile).map(scramble).collect()),
        ("equal keys", vec![0xffff; several as usize]),
        ("falling keys", (0..several).rev().collect()),
        (
            "one digit",
            (0..several)
                .map(|at| scramble(at) & 0xff00 | 0x7f)
                .collect(),
        ),
        (
            "alternating keys",
            (0..several)
                .map(|at| if at % 2 == 0 { 0 } else { 0xffff })
                .collect(),
        ),
        (
            "some culled keys",
            (0..KEYS).map(|at| drop(at, scramble(at))).collect(),
        ),
        spread(),
    ]
}
