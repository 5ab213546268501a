//! What a layout is, and what several have in common.

/// Where a layout has its files.
pub struct FolderLayout {
    /// What the layout is called.
    pub name: &'static str,
    /// The file with all cameras, by which it is known.
    pub calibration: &'static str,
    /// Folder of a camera's pictures.
    pub pictures: fn(camera: &str) -> String,
    /// Folder of a camera's masks.
    pub masks: fn(camera: &str) -> String,
    /// Number of the frame that a file in these is of, from its name without ending.
    pub number: fn(stem: &str) -> Option<u32>,
}

/// The only number in a name such as `00000012_mask` or `frame_12.jpg`; None: it has no number, or
/// several.
pub fn only_number(stem: &str) -> Option<u32> {
    let mut numbers = stem
        .split(|c: char| !c.is_ascii_digit())
        .filter(|run| !run.is_empty());
    let first = numbers.next().and_then(digits);
    first.filter(|_| numbers.next().is_none())
}

/// A number of at most eight digits.
pub fn digits(stem: &str) -> Option<u32> {
    let plain = (1..=8).contains(&stem.len()) && stem.bytes().all(|byte| byte.is_ascii_digit());
    plain.then(|| stem.parse().ok()).flatten()
}
