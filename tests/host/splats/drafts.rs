//! Drafts of glTF's splat extension, and what else its files have.

use effigy_formats::splats::{self, Found, Nothing, SplatFormat};

/// A GLB of two splats, whose attributes are floats. `attributes`: names and numbers of a splat.
fn glb(attributes: &[(&str, usize)], extension: &str, node: &str) -> Vec<u8> {
    let mut binary: Vec<u8> = vec![];
    let mut of_mesh = vec![];
    let mut accessors = vec![];
    let mut views = vec![];
    for (index, (name, width)) in attributes.iter().enumerate() {
        let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"][width - 1];
        of_mesh.push(format!(r#""{name}": {index}"#));
        accessors.push(format!(
            r#"{{"bufferView": {index}, "componentType": 5126, "count": 2, "type": "{shape}"}}"#
        ));
        let length = 8 * width;
        views.push(format!(
            r#"{{"buffer": 0, "byteOffset": {}, "byteLength": {length}}}"#,
            binary.len()
        ));
        for row in 0..2 {
            for column in 0..*width {
                binary.extend((0.1 + 0.2 * column as f32 + 0.05 * row as f32).to_le_bytes());
            }
        }
    }
    let document = format!(
        r#"{{"asset": {{"version": "2.0"}}, "extensionsUsed": ["KHR_gaussian_splatting"],
        "nodes": [{{"mesh": 0{node}}}], "scenes": [{{"nodes": [0]}}],
        "meshes": [{{"primitives": [{{"attributes": {{{}}}, "extensions": {{{extension}}}}}]}}],
        "accessors": [{}], "bufferViews": [{}], "buffers": [{{"byteLength": {}}}]}}"#,
        of_mesh.join(","),
        accessors.join(","),
        views.join(","),
        binary.len()
    );
    let total = 28 + document.len() + binary.len();
    [
        b"glTF\x02\0\0\0",
        &(total as u32).to_le_bytes()[..],
        &(document.len() as u32).to_le_bytes(),
        b"JSON",
        document.as_bytes(),
        &(binary.len() as u32).to_le_bytes(),
        b"BIN\0",
        &binary,
    ]
    .concat()
}

const EMPTY: &str = r#""KHR_gaussian_splatting": {}"#;

fn read(bytes: &[u8]) -> Result<Found, String> {
    splats::read(bytes, SplatFormat::Glb, &mut Nothing).map_err(|error| error.to_string())
}

fn said(found: &Found) -> String {
    let lines: Vec<String> = found.assumptions.iter().map(ToString::to_string).collect();
    lines.join("\n")
}

fn near(a: f32, b: f32) -> bool {
    (a - b).abs() < 1e-5
}

fn the_draft_of_2025_is_read() {
    let draft = [
        ("POSITION", 3),
        ("_ROTATION", 4),
        ("_SCALE", 3),
        ("COLOR_0", 4),
    ];
    let found = read(&glb(&draft, EMPTY, "")).unwrap();
    let line = "attributes: COLOR_0, _ROTATION and _SCALE (the file is of a draft of KHR_gaussian_splatting)";
    assert_eq!(said(&found), line);
    let splats = found.splats;
    let rotation = [0.75, 0.15, 0.35, 0.55];
    assert!(
        splats.rotation[1]
            .iter()
            .zip(rotation)
            .all(|(a, b)| near(*a, b))
    );
    assert!(
        splats.log_scale[0]
            .iter()
            .zip([0.1f32, 0.3, 0.5])
            .all(|(a, b)| near(*a, b.ln()))
    );
    assert!(
        near(splats.opacity[0], (0.7f32 / 0.3).ln()),
        "{:?}",
        splats.opacity
    );
    let color = splats.color[0].map(|c| 0.5 + 0.282_094_8 * c);
    assert!(
        color.iter().zip([0.1, 0.3, 0.5]).all(|(a, b)| near(*a, b)),
        "{color:?}"
    );
    let opaque = [
        ("POSITION", 3),
        ("_ROTATION", 4),
        ("_SCALE", 3),
        ("COLOR_0", 3),
    ];
    assert_eq!(
        read(&glb(&opaque, EMPTY, "")).unwrap().splats.opacity,
        [f32::INFINITY; 2]
    );
    let mut with_harmonics = draft.to_vec();
    with_harmonics.extend([
        ("_SH_DEGREE_1_COEF_0", 3),
        ("_SH_DEGREE_1_COEF_1", 3),
        ("_SH_DEGREE_1_COEF_2", 3),
    ]);
    let found = read(&glb(&with_harmonics, EMPTY, "")).unwrap();
    assert_eq!((found.splats.degree, said(&found)), (1, line.into()));
}

fn attributes_are_listed() {
    let missing = read(&glb(&[("POSITION", 3), ("NORMAL", 3)], EMPTY, "")).unwrap_err();
    let expected = "found no attribute `KHR_gaussian_splatting:ROTATION` among NORMAL, POSITION";
    assert!(missing.starts_with(expected), "{missing}");
    let own = |name: &str| format!("KHR_gaussian_splatting:{name}");
    let names = ["ROTATION", "SCALE", "OPACITY", "SH_DEGREE_0_COEF_0"].map(own);
    let widths = [4, 3, 1, 3];
    let mut all: Vec<(&str, usize)> = names.iter().map(String::as_str).zip(widths).collect();
    all.extend([("POSITION", 3), ("COLOR_0", 4), ("NORMAL", 3)]);
    assert_eq!(said(&read(&glb(&all, EMPTY, "")).unwrap()), "");
    all.extend([
        ("_BATCHID", 1),
        ("KHR_gaussian_splatting:SH_DEGREE_4_COEF_0", 3),
    ]);
    let line = said(&read(&glb(&all, EMPTY, "")).unwrap());
    let expected = "attributes: KHR_gaussian_splatting:SH_DEGREE_4_COEF_0, _BATCHID left out";
    assert!(line.starts_with(expected), "{line}");
}

/// Tiles of a globe stand at its surface, millions of metres from its centre.
fn a_node_that_is_far_keeps_its_splats_precise() {
    let draft = [
        ("POSITION", 3),
        ("_ROTATION", 4),
        ("_SCALE", 3),
        ("COLOR_0", 4),
    ];
    let plain = read(&glb(&draft, EMPTY, "")).unwrap();
    let node = r#", "translation": [1215013.25, -4736323.5, 4081604.125]"#;
    let far = read(&glb(&draft, EMPTY, node)).unwrap();
    assert!(
        said(&far).contains("place: 1215013, -4736324, 4081604 is the new origin"),
        "{}",
        said(&far)
    );
    for (far, plain) in far.splats.position.iter().zip(plain.splats.position) {
        let moved = [plain[0] + 0.25, plain[1] + 0.5, plain[2] + 0.125];
        assert!(
            far.iter().zip(moved).all(|(a, b)| near(*a, b)),
            "{far:?} {moved:?}"
        );
    }
}

fn version_1_is_named() {
    let text = br#"{"asset": {"version": "1.0"}, "accessors": {"a": {}}, "meshes": {}, "nodes": {}, "animations": {}}"#;
    let splats = splats::read(text, SplatFormat::Gltf, &mut Nothing).unwrap_err();
    let motion = effigy_formats::gltf_motion::from_bytes(text, &Default::default(), &mut |_| None);
    for said in [splats.to_string(), motion.unwrap_err().to_string()] {
        assert!(
            said.starts_with("found version 1.0 of glTF, expected version 2"),
            "{said}"
        );
    }
}

tests! {
    the_draft_of_2025_is_read,
    attributes_are_listed,
    a_node_that_is_far_keeps_its_splats_precise,
    version_1_is_named,
}
