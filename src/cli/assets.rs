//! Where the folder is that tools/fetch_assets.sh and tools/fetch_perceptual.sh fill.

use effigy_learn::bake::Assets;
use std::path::{Path, PathBuf};

/// The folder that is meant where neither an option nor EFFIGY_ASSETS names one: that of the clone
/// which the program was built in, from wherever it is run, else the one below the current folder.
pub fn folder() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    beside(&program).unwrap_or_else(|| Assets::DEFAULT.into())
}

/// The folder of a clone that has a program somewhere below it.
fn beside(program: &Path) -> Option<PathBuf> {
    let mut folders = program.ancestors().skip(1);
    folders.find_map(|above| Some(above.join(Assets::DEFAULT)).filter(|found| found.is_dir()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_program_finds_the_folder_of_its_clone() {
        let clone = tempfile::tempdir().unwrap();
        let program = clone.path().join("target/release/effigy");
        assert_eq!(beside(&program), None);
        let assets = clone.path().join(Assets::DEFAULT);
        fs::create_dir_all(&assets).unwrap();
        assert_eq!(beside(&program), Some(assets.clone()));
        assert_eq!(
            beside(&clone.path().join("target/debug/deps/effigy")),
            Some(assets)
        );
    }
}
