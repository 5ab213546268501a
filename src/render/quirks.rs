//! Faults and fast paths of drivers that no query tells, by the names of drivers and devices.

/// Whether a device draws triangles, by its name. llvmpipe at 512 bits ends the program that does:
/// any program, with Mesa 22.3 and 25.0.
pub fn draws_triangles(device: &str) -> bool {
    !(device.starts_with("llvmpipe") && device.contains(" 512 bits"))
}

/// The fault of a device where [`draws_triangles`] is false.
pub const NO_TRIANGLES: &str =
    "its driver crashes when it draws triangles with vectors of 512 bits";

/// Whether a driver takes ten seconds and more to compile kernels whose subgroups shuffle, in which
/// another way to draw shows its first picture.
pub fn compiles_shuffles_slowly(driver: &str) -> bool {
    driver.starts_with("SwiftShader")
}

/// Whether a driver leaves an invocation's loops after 65,535 rounds of all of them together, as
/// llvmpipe did. Seen with Mesa 22.3, not with 25.0; between them it was not tried.
pub fn leaves_loops(driver: &str) -> bool {
    let number = |text: &str| {
        text.split(|c: char| !c.is_ascii_digit())
            .next()
            .and_then(|digits| digits.parse::<u32>().ok())
    };
    driver.starts_with("llvmpipe")
        && driver
            .split_once("Mesa ")
            .and_then(|(_, version)| number(version))
            .is_none_or(|version| version < 25)
}

/// What it means that a driver leaves loops, and which does not.
pub const OLD_LAVAPIPE: &str = "tiles would lose parts of large scenes, and quads are slower: \
    Mesa 25's lavapipe has no such limit; on Debian 12 `tools/start.sh` fetches it";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_old_llvmpipe_leaves_loops() {
        for (driver, leaves) in [
            ("llvmpipe Mesa 25.0.7 (LLVM 15.0.6)", false),
            ("llvmpipe Mesa 26.1.0-devel (git-0123456789)", false),
            ("llvmpipe Mesa 22.3.6 (LLVM 15.0.6)", true),
            ("llvmpipe", true),
            ("SwiftShader driver", false),
            ("NVIDIA 570.1", false),
        ] {
            assert_eq!(leaves_loops(driver), leaves, "{driver}");
        }
    }
}
