//! SOGs as other programs wrote them at first, in folders, and in levels of detail.

use super::{SOG_2, errors};
use effigy_formats::{
    content::Content,
    open,
    splats::{self, Found, Nothing, SplatFormat},
};
use std::{
    fs,
    io::{Cursor, Read, Write},
    path::Path,
};
use zip::{ZipArchive, ZipWriter, write::SimpleFileOptions};

/// Unpacks the SOG of the test data into a folder, its document changed.
fn unpack(folder: &Path, change: impl Fn(String) -> String) {
    fs::create_dir_all(folder).unwrap();
    let mut archive = ZipArchive::new(Cursor::new(SOG_2.bytes)).unwrap();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).unwrap();
        let name = entry.name().unwrap().into_owned();
        let mut bytes = vec![];
        entry.read_to_end(&mut bytes).unwrap();
        if name == "meta.json" {
            bytes = change(String::from_utf8(bytes).unwrap()).into_bytes();
        }
        fs::write(folder.join(name), bytes).unwrap();
    }
}

/// A zip of the files of a folder, under a name of it.
fn zipped(folder: &Path, under: &str) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{under}{}", path.file_name().unwrap().to_string_lossy());
        writer
            .start_file(name, SimpleFileOptions::default())
            .unwrap();
        writer.write_all(&fs::read(path).unwrap()).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

fn read_zip(bytes: &[u8]) -> Result<Found, String> {
    splats::read(bytes, SplatFormat::Sog, &mut Nothing).map_err(|error| error.to_string())
}

fn a_sog_may_be_zipped_with_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    unpack(folder.path(), |text| text);
    for under in ["", "scan/", "a/b c/"] {
        let bytes = zipped(folder.path(), under);
        let content = Content::of(&bytes, Path::new("a.zip"));
        assert_eq!(content, Content::Splats(SplatFormat::Sog));
        assert_eq!(read_zip(&bytes).unwrap().splats, SOG_2.read(), "{under}");
    }
}

/// The first number of a codebook, in the document's text.
fn nulled(text: &str, key: &str, nth: usize) -> String {
    let start = text.find(&format!("\"{key}\"")).unwrap();
    let open = start + text[start..].find("\"codebook\":[").unwrap() + "\"codebook\":[".len();
    let close = open + text[open..].find(']').unwrap();
    let mut numbers: Vec<&str> = text[open..close].split(',').collect();
    numbers[nth] = "null";
    format!("{}{}{}", &text[..open], numbers.join(","), &text[close..])
}

fn codebooks_may_begin_with_null() {
    let folder = tempfile::tempdir().unwrap();
    for key in ["scales", "sh0", "shN"] {
        unpack(folder.path(), |text| nulled(&text, key, 0));
        let read = read_zip(&zipped(folder.path(), "")).unwrap().splats;
        let off = errors(&SOG_2.read(), &read);
        // A code of 64 splats may be the first: by the steps of the others it is near.
        assert!(
            off.log_scale < 0.1 && off.color < 0.1 && off.harmonics < 0.1,
            "{key}: {off:?}"
        );
    }
    unpack(folder.path(), |text| nulled(&text, "scales", 9));
    let refused = read_zip(&zipped(folder.path(), "")).unwrap_err();
    assert!(refused.contains("null at 9 of the codebook"), "{refused}");
}

/// Leaves of two files: at level 0 all splats of one and some of the other.
fn the_finest_level_of_a_streamed_sog_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    for part in ["0_0", "0_1", "1_0", "env"] {
        unpack(&path.join(part), |text| text);
    }
    let lods = |file: usize, offset: usize, count: usize| {
        format!(
            r#"{{"bound": {{}}, "lods": {{"0": {{"file": {file}, "offset": {offset}, "count": {count}}},
            "1": {{"file": 2, "offset": 0, "count": 8}}}}}}"#
        )
    };
    let write = |environment: &str, leaves: &[String]| {
        let text = format!(
            r#"{{"lodLevels": 2, "environment": {environment},
            "filenames": ["0_0/meta.json", "0_1/meta.json", "1_0/meta.json"],
            "tree": {{"bound": {{}}, "children": [{{"children": [{}]}}]}}}}"#,
            leaves.join(",")
        );
        fs::write(path.join("lod-meta.json"), text).unwrap();
        open::splats(&path.join("lod-meta.json"), None)
    };
    let all = SOG_2.read();
    let leaves = [lods(0, 30, 34), lods(1, 10, 5), lods(0, 0, 30)];
    let found = write("null", &leaves).unwrap();
    assert_eq!(found.splats, all.clone().joined(all.part(10..15)));
    assert_eq!(
        found.assumptions[0].to_string(),
        "level of detail: 0 (it is the finest)"
    );
    let found = write("\"env/meta.json\"", &leaves[1..2]).unwrap();
    assert_eq!(found.splats, all.part(10..15).joined(all.clone()));
    // More than an avatar holds: the next level.
    let found = write("null", &[lods(0, 0, 3_000_000)]).unwrap();
    assert_eq!(found.splats, all.part(0..8));
    assert!(
        found.assumptions[0]
            .to_string()
            .starts_with("level of detail: 1 (finer ones")
    );
    for (leaf, expected) in [
        (lods(0, 60, 5), "splats beyond the 64 of `0_0/meta.json`"),
        (lods(9, 0, 5), "file 9, expected one of 3"),
        (lods(0, 0, usize::MAX), "level of detail"),
    ] {
        let said = write("null", &[leaf]);
        let said = said.map_or_else(
            |error| error.to_string(),
            |found| found.assumptions[0].to_string(),
        );
        assert!(said.contains(expected), "{said}");
    }
    // Levels that nobody made are not walked through one by one.
    let last = r#"{"lods": {"4294967295": {"file": 0, "offset": 0, "count": 3000000}}}"#;
    let refused = write("null", &[last.into()]).unwrap_err().to_string();
    assert!(refused.contains("3000000"), "{refused}");
    let level =
        |k: usize| format!(r#"{{"lods": {{"{k}": {{"file": 0, "offset": 0, "count": 1}}}}}}"#);
    let many: Vec<String> = (0..100).map(level).collect();
    let refused = write("null", &many).unwrap_err().to_string();
    assert!(refused.contains("more than 64 levels"), "{refused}");
    fs::remove_dir_all(path.join("0_0")).unwrap();
    let missing = write("null", &leaves).unwrap_err().to_string();
    assert!(missing.contains("`0_0/meta.json`"), "{missing}");
}

tests! {
    a_sog_may_be_zipped_with_its_folder,
    codebooks_may_begin_with_null,
    the_finest_level_of_a_streamed_sog_is_drawn,
}
