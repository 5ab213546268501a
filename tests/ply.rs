//! 3DGS's `.ply` and `cameras.json`: what they hold arrives, what is wrong with them is named, and what we write can be read back.

mod common;
#[path = "files/memory.rs"]
mod memory;

use common::{Random, Sizes};
use effigy::{
    avatar::{
        Avatar, Clip, Harmonics,
        export::{self, Uniform},
        import::{self, Up, cameras},
        limits,
    },
    cli::source::Source,
    frame::{Camera, Extent, Posed},
    measure::error,
    reference,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use proptest::prelude::*;

#[global_allocator]
static COUNTING: memory::Counting = memory::Counting;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Encoding {
    Ascii,
    Little,
    Big,
}

/// Names and numbers of a file's vertices.
#[derive(Clone)]
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f32>>,
}

impl Table {
    /// Gaussians from a seed, with harmonics of a degree, in 3DGS's order.
    fn new(seed: u64, count: usize, degree: usize) -> Self {
        let random = &mut Random(seed);
        let fixed = |names: &str| names.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let rest = 3 * ((degree + 1).pow(2) - 1);
        let mut names = fixed("x y z nx ny nz f_dc_0 f_dc_1 f_dc_2");
        names.extend((0..rest).map(|k| format!("f_rest_{k}")));
        names.extend(fixed("opacity scale_0 scale_1 scale_2 rot_0 rot_1 rot_2 rot_3"));
        let mut row = || {
            let mut row = random.vector(1.0).to_array().to_vec();
            row.extend([0.0; 3]);
            row.extend((0..3 + rest).map(|k| random.range(-1.0, 1.0) * if k < 3 { 1.5 } else { 0.3 }));
            row.push(random.range(-3.0, 5.0));
            row.extend((0..3).map(|_| random.range(-5.0, -3.0)));
            row.extend((0..4).map(|_| random.range(-2.0, 2.0)));
            row.into_iter().map(|v| v as f32).collect()
        };
        Self { rows: (0..count).map(|_| row()).collect(), names }
    }

    fn column(&self, name: &str) -> usize {
        self.names.iter().position(|known| known == name).unwrap()
    }

    fn set(mut self, row: usize, name: &str, value: f32) -> Self {
        let column = self.column(name);
        self.rows[row][column] = value;
        self
    }

    fn without(mut self, name: &str) -> Self {
        let column = self.column(name);
        self.names.remove(column);
        self.rows.iter_mut().for_each(|row| {
            row.remove(column);
        });
        self
    }

    /// The same with its properties in another order.
    fn shuffled(mut self) -> Self {
        let turn = self.names.len() / 3;
        self.names.rotate_left(turn);
        self.names.swap(0, 5);
        for row in &mut self.rows {
            row.rotate_left(turn);
            row.swap(0, 5);
        }
        self
    }

    fn header(&self, encoding: Encoding, count: usize) -> String {
        let format = match encoding {
            Encoding::Ascii => "ascii",
            Encoding::Little => "binary_little_endian",
            Encoding::Big => "binary_big_endian",
        };
        let properties: String = self.names.iter().map(|name| format!("property float {name}\n")).collect();
        format!("ply\nformat {format} 1.0\nelement vertex {count}\n{properties}end_header\n")
    }

    fn bytes(&self, encoding: Encoding) -> Vec<u8> {
        let mut bytes = self.header(encoding, self.rows.len()).into_bytes();
        for row in &self.rows {
            match encoding {
                Encoding::Ascii => {
                    let words: Vec<String> = row.iter().map(f32::to_string).collect();
                    bytes.extend(format!("{}\n", words.join(" ")).into_bytes());
                }
                Encoding::Little => bytes.extend(row.iter().flat_map(|v| v.to_le_bytes())),
                Encoding::Big => bytes.extend(row.iter().flat_map(|v| v.to_be_bytes())),
            }
        }
        bytes
    }

    fn read(&self, encoding: Encoding) -> Result<Avatar, String> {
        read(&self.bytes(encoding))
    }
}

fn read(bytes: &[u8]) -> Result<Avatar, String> {
    import::from_bytes(bytes, "test", None).map_err(|fault| fault.to_string())
}

#[test]
fn every_encoding_and_order_gives_the_same_avatar() {
    for degree in 0..=3 {
        let table = Table::new(degree as u64, 100, degree);
        let avatar = table.read(Encoding::Little).unwrap();
        assert_eq!(avatar.harmonics.as_ref().map_or(0, |harmonics| harmonics.degree), degree);
        for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
            assert_eq!(table.read(encoding).unwrap(), avatar);
            assert_eq!(table.clone().shuffled().read(encoding).unwrap(), avatar);
        }
    }
}

/// Every Gaussian of the file, found again by its position, has the file's numbers within what an avatar's types can hold.
#[test]
fn numbers_arrive_as_3dgs_means_them() {
    let table = Table::new(7, 200, 3);
    let avatar = table.read(Encoding::Little).unwrap();
    let (g, harmonics) = (&avatar.gaussians, avatar.harmonics.as_ref().unwrap());
    let step = g.bounds.step().max_element();
    for row in &table.rows {
        let get = |name: &str| f64::from(row[table.column(name)]);
        let three = |name: &str| DVec3::from_array(std::array::from_fn(|k| get(&format!("{name}_{k}"))));
        let at = DVec3::new(get("x"), get("y"), get("z"));
        let found = (0..g.len()).find(|&i| (avatar.position(i) - at).abs().max_element() <= 0.51 * step).expect("its place is known");
        let vector = |v: [half::f16; 3]| DVec3::from(v.map(f64::from));
        assert!((vector(g.log_scale[found]) - three("scale")).abs().max_element() <= 2e-3);
        assert!((vector(g.color[found]) - (0.5 + 0.282_094_791_773_878 * three("f_dc"))).abs().max_element() <= 5e-4);
        assert!((f64::from(g.opacity[found]) / 255.0 - 1.0 / (1.0 + (-get("opacity")).exp())).abs() <= 0.51 / 255.0);
        let [w, x, y, z] = g.rotation[found].map(f64::from);
        let (got, expected) = (DQuat::from_xyzw(x, y, z, w), DQuat::from_xyzw(get("rot_1"), get("rot_2"), get("rot_3"), get("rot_0")));
        assert!((got.normalize().dot(expected.normalize()).abs() - 1.0).abs() <= 1e-6);
        for function in 0..15 {
            let expected = DVec3::from_array(std::array::from_fn(|channel| get(&format!("f_rest_{}", 15 * channel + function))));
            assert!((vector(harmonics.coefficients[15 * found + function]) - expected).abs().max_element() <= 2e-4);
        }
    }
}

#[test]
fn neighbours_in_memory_are_neighbours_in_space() {
    let avatar = Table::new(1, 4000, 0).read(Encoding::Little).unwrap();
    let path: f64 = (1..4000).map(|i| avatar.position(i).distance(avatar.position(i - 1))).sum();
    // At random, two points of a cube of side 2 are 1.32 apart.
    assert!(path / 3999.0 < 0.3, "{} from one to the next", path / 3999.0);
}

#[test]
fn the_files_up_becomes_y() {
    let table = Table::new(3, 50, 0);
    let bytes = table.bytes(Encoding::Little);
    let ours = String::from_utf8_lossy(&bytes[..4]).into_owned() + "comment effigy up z\n";
    let ours = [ours.as_bytes(), &bytes[4..]].concat();
    let world = |bytes: &[u8], up| {
        let avatar = import::from_bytes(bytes, "", up).unwrap();
        let posed = Posed::new(&avatar, &Clip::still(&avatar.skeleton).sample(0.0));
        posed.joints[0].transform_vector3(DVec3::new(1.0, 2.0, 3.0))
    };
    for (bytes, up, expected) in [
        (&bytes, None, [1.0, -2.0, -3.0]),
        (&bytes, Some(Up::Y), [1.0, 2.0, 3.0]),
        (&bytes, Some(Up::MinusY), [1.0, -2.0, -3.0]),
        (&bytes, Some(Up::Z), [1.0, 3.0, -2.0]),
        (&bytes, Some(Up::MinusZ), [1.0, -3.0, 2.0]),
        (&ours, None, [1.0, 3.0, -2.0]),
        (&ours, Some(Up::Y), [1.0, 2.0, 3.0]),
    ] {
        assert!(world(bytes, up).distance(DVec3::from(expected)) < 1e-6, "{up:?}: {}", world(bytes, up));
    }
}

#[test]
fn numbers_beyond_what_is_stored_stay_finite() {
    let table = Table::new(2, 9, 1)
        .set(0, "opacity", f32::INFINITY)
        .set(1, "opacity", f32::NEG_INFINITY)
        .set(2, "scale_1", f32::NEG_INFINITY)
        .set(3, "scale_1", 1e30)
        .set(4, "f_dc_0", 1e30)
        .set(5, "f_rest_3", -1e30);
    let avatar = table.read(Encoding::Little).unwrap();
    assert!(avatar.gaussians.opacity.contains(&0) && avatar.gaussians.opacity.contains(&255));
    assert!(avatar.gaussians.log_scale.iter().chain(&avatar.gaussians.color).flatten().all(|v| v.is_finite()));
    assert!(avatar.harmonics.unwrap().coefficients.iter().flatten().all(|v| v.is_finite()));
    let pictures = Table::new(2, 1, 0).set(0, "x", 5.0).read(Encoding::Ascii).unwrap();
    assert!(pictures.position(0).distance(DVec3::new(5.0, pictures.position(0).y, pictures.position(0).z)) < 1e-6, "a box without width");
}

#[test]
fn each_fault_is_named() {
    let table = || Table::new(5, 4, 1);
    let found = |table: Table| table.read(Encoding::Little).unwrap_err();
    let cases = [
        (found(table().without("opacity")), "found no `opacity` among the properties, expected"),
        (found(table().without("f_rest_8")), "found 8 properties f_rest, expected 0, 9, 24 or 45"),
        (found(table().set(2, "y", f32::NAN)), "found NaN in the position of vertex 2, expected finite numbers"),
        (found(table().set(2, "y", 2e4)), "found the position ["),
        (found(table().set(3, "f_dc_1", f32::INFINITY)), "found inf in the colour of vertex 3"),
        (found(table().set(1, "f_rest_5", f32::NAN)), "found NaN in the harmonics of vertex 1"),
        (found(table().set(1, "rot_3", f32::NEG_INFINITY)), "found -inf in the rotation of vertex 1"),
        (found(table().set(0, "scale_0", f32::INFINITY)), "found scale [inf"),
        (found(table().set(0, "opacity", f32::NAN)), "found scale ["),
        (
            found((0..4).fold(table(), |table, k| table.set(1, &format!("rot_{k}"), 0.0))),
            "found a quaternion of length 0 at vertex 1, expected any other length",
        ),
        (found(Table { rows: vec![], ..table() }), "found 0 Gaussians, expected 1 to 2000000"),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
    let compressed = "ply\nformat binary_little_endian 1.0\nelement chunk 1\nproperty float min_x\nelement vertex 1\n\
                      property uint packed_position\nend_header\n";
    assert!(read(&[compressed.as_bytes(), &[0; 8]].concat()).unwrap_err().starts_with("found a compressed .ply, expected a plain"));
}

#[test]
fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    let table = Table::new(5, 3, 0);
    for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
        let bytes = table.bytes(encoding);
        // The last line's end may be missing.
        for end in 0..bytes.len() - usize::from(encoding == Encoding::Ascii) {
            let cut = read(&bytes[..end]);
            // Cut inside its last number, a text is a shorter number.
            let last = encoding == Encoding::Ascii && !bytes[end..].contains(&b' ');
            assert!(cut.is_err() || last, "{end} bytes of {}", bytes.len());
        }
        assert!(read(&bytes).is_ok());
    }
    let short = [table.header(Encoding::Little, 3).as_bytes(), &[0; 100]].concat();
    assert!(read(&short).unwrap_err().starts_with("found 1 vertices, expected 3 as the header says; the file is incomplete"));
}

#[test]
fn text_that_is_no_number_is_named() {
    let table = Table::new(5, 2, 0);
    let text = |line: &str| read(format!("{}{line}\n{line}\n", table.header(Encoding::Ascii, 2)).as_bytes()).unwrap_err();
    assert_eq!(text(&"1 ".repeat(16)), "found `` in the line of vertex 0, expected 17 numbers");
    assert_eq!(text(&"1 ".repeat(18)), "found `1` at the end of the line of vertex 0, expected 17 numbers");
    assert_eq!(text(&format!("one {}", "1 ".repeat(16))), "found `one` in the line of vertex 0, expected 17 numbers");
}

/// Vertices that the file does not hold cost no memory, and those it holds cost a small multiple of its size.
#[test]
fn memory_follows_from_the_file_not_from_its_word() {
    let table = Table::new(5, 1, 0);
    for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
        for count in [3, 1000, limits::GAUSSIANS, limits::GAUSSIANS + 1, u32::MAX as usize, usize::MAX] {
            let bytes = [table.header(encoding, count).as_bytes(), &[b'1'; 200]].concat();
            let (result, peak) = memory::peak(|| read(&bytes));
            assert!(result.is_err() && peak < 100_000, "{count} vertices: {peak} bytes");
        }
    }
    let bytes = Table::new(6, 5000, 3).bytes(Encoding::Ascii);
    let (result, peak) = memory::peak(|| read(&bytes));
    assert!(result.is_ok() && peak < 3 * bytes.len(), "{peak} bytes for a file of {}", bytes.len());
}

#[test]
fn a_static_avatar_needs_no_clip() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.ply");
    std::fs::write(&path, Table::new(1, 20, 2).bytes(Encoding::Little)).unwrap();
    let (avatar, clips) = Source { avatar: Some(path), motion: vec![], up: Some(Up::Y) }.load().unwrap();
    assert!(avatar.is_static() && avatar.name == "scene");
    assert_eq!((clips.len(), clips[0].frames(), clips[0].duration()), (1, 1, 0.0));
    let posed = Posed::new(&avatar, &clips[0].sample(0.0));
    assert!(posed.joints[0].abs_diff_eq(DAffine3::IDENTITY, 1e-12));
    let missing = Source { avatar: Some(folder.path().join("none.ply")), motion: vec![], up: None }.load().unwrap_err();
    assert!(missing.to_string().contains("cannot read"), "{missing}");
}

#[cfg(feature = "window")]
#[test]
fn the_viewer_rests_on_a_static_avatar() {
    let avatar = Table::new(1, 20, 2).read(Encoding::Little).unwrap();
    let clips = vec![Clip::still(&avatar.skeleton)];
    let mut scene = effigy::app::scene::Scene::new(avatar, clips, [0.5; 3], ([300, 200], 0.0));
    assert!(!scene.is_moving(), "the play bar is idle");
    let first = scene.advance(0.5, [300, 200]);
    assert!(scene.advance(3.0, [300, 200]) == first);
}

/// Pictures of an avatar in motion and of its file agree: the reference draws both.
#[test]
fn an_exported_pose_looks_like_the_avatar() {
    let avatar = common::avatar(4, Sizes { gaussians: 8000, ..Sizes::default() });
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let camera = common::gpu::camera(&avatar, &posed, [300, 300]);
    let stages = reference::Stages::new(&avatar, &posed, &camera);
    let file = import::from_bytes(&export::to_ply(&stages.gaussians, None), "", None).unwrap();
    let still = Posed::new(&file, &Clip::still(&file.skeleton).sample(0.0));
    let error = error::between(&reference::render(&file, &still, &camera), &stages.canvas.to_picture());
    assert!(error.covered.psnr_db >= 50.0 && error.covered.pixels > 1000, "{error:?}");
    let opacity = |avatar: &Avatar| {
        let mut sorted = avatar.gaussians.opacity.clone();
        sorted.sort_unstable();
        sorted
    };
    assert_eq!(opacity(&file), opacity(&avatar), "eight bits of opacity come back");
}

#[test]
fn a_uniform_body_is_of_equal_balls() {
    let avatar = common::avatar(4, Sizes { gaussians: 500, ..Sizes::default() });
    let posed = Posed::new(&avatar, &common::pose(5, &avatar));
    let stages = reference::Stages::new(&avatar, &posed, &common::gpu::camera(&avatar, &posed, [20, 20]));
    let body = export::to_ply(&stages.gaussians, Some(Uniform { deviation: 0.003, opacity: 0.9 }));
    let body = import::from_bytes(&body, "", None).unwrap();
    assert!(body.gaussians.log_scale.as_flattened().iter().all(|s| (s.to_f64().exp() - 0.003).abs() < 1e-5));
    assert!(body.gaussians.opacity.iter().all(|&o| o == 230));
    let [min, max] = Extent::new(&avatar).bounds(&posed.joints);
    assert!((0..500).all(|i| body.position(i).cmpge(min).all() && body.position(i).cmple(max).all()));
}

/// What 3DGS writes: a camera two metres before the origin (COLMAP's z points forward), turned a quarter about its own axis.
const CAMERAS: &str = r#"[{"id": 0, "img_name": "a", "width": 640, "height": 480, "position": [0, 0, -2],
    "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "fy": 500, "fx": 400, "extra": 1}]"#;

#[test]
fn cameras_see_what_3dgs_sees() {
    let camera = cameras::parse(CAMERAS.as_bytes(), DAffine3::IDENTITY).unwrap()[0];
    assert_eq!((camera.size, camera.focal, camera.center), ([640, 480], DVec2::new(400.0, 500.0), DVec2::new(320.0, 240.0)));
    assert!(camera.eye().distance(DVec3::new(0.0, 0.0, -2.0)) < 1e-12);
    // The camera's x axis is the world's y; its y axis, down in the picture, the world's −x.
    let at = camera.project(camera.view.transform_point3(DVec3::new(0.1, 0.2, 0.0)));
    assert!(at.distance(DVec2::new(320.0 + 400.0 * 0.1, 240.0 - 500.0 * 0.05)) < 1e-9, "{at}");
    let turned = DAffine3::from_quat(Up::TRAINED.rotation());
    let turned = cameras::parse(CAMERAS.as_bytes(), turned).unwrap()[0];
    assert!(turned.eye().distance(DVec3::new(0.0, 0.0, 2.0)) < 1e-12);
    let again = turned.project(turned.view.transform_point3(DVec3::new(0.1, -0.2, 0.0)));
    assert!(again.distance(at) < 1e-9, "the same point in turned axes: {again}");
    let half = cameras::scaled(&camera, [400, 240]);
    assert_eq!((half.size, half.focal, half.center), ([400, 240], DVec2::new(200.0, 250.0), DVec2::new(200.0, 120.0)));
}

#[test]
fn cameras_come_back_as_they_are_written() {
    let written: Vec<_> =
        (0..5).map(|k| Camera::orbit(DVec3::new(0.1, 0.9, 0.0), f64::from(k), 0.1 * f64::from(k), 3.0, 0.6, [200, 100 + k])).collect();
    let read = cameras::parse(cameras::to_json(&written).as_bytes(), DAffine3::IDENTITY).unwrap();
    assert_eq!(read.len(), written.len());
    for (read, written) in read.iter().zip(&written) {
        assert!(read.view.abs_diff_eq(written.view, 1e-12) && read.focal.abs_diff_eq(written.focal, 1e-9));
        assert_eq!((read.size, read.center, read.near), (written.size, written.center, written.near));
    }
}

#[test]
fn cameras_that_cannot_see_are_named() {
    let with = |from: &str, to: &str| cameras::parse(CAMERAS.replace(from, to).as_bytes(), DAffine3::IDENTITY).unwrap_err().to_string();
    let cases = [
        (with("640", "0"), "found a picture of 0 × 480 px at camera 0, expected sides from 1 to 65536 px"),
        (with("\"fx\": 400", "\"fx\": 0"), "found focal lengths of 0 and 500 px at camera 0"),
        (with("[0, -1, 0]", "[0, -2, 0]"), "found the matrix [[0.0, -2.0, 0.0]"),
        (with("[0, -1, 0]", "[0, 1, 0]"), "found the matrix [[0.0, 1.0, 0.0]"),
        (with("[0, 0, -2]", "[0, 0, 1e999]"), "found number out of range"),
        (with("\"width\": 640, ", ""), "found missing field `width`"),
        (with("[{", "{"), "found "),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
    assert!(cameras::parse(b"[]", DAffine3::IDENTITY).unwrap_err().to_string().starts_with("found 0 cameras, expected 1 to"));
}

/// What is read keeps the rules that drawing relies on.
fn keeps_the_rules(avatar: &Avatar) {
    let g = &avatar.gaussians;
    let finite = |v: &half::f16| v.is_finite();
    assert!(g.rotation.as_flattened().iter().all(finite) && g.rotation.iter().all(|q| q.iter().any(|v| v.to_f64() != 0.0)));
    assert!(g.log_scale.as_flattened().iter().chain(g.color.as_flattened()).all(finite));
    assert!((0..3).all(|k| g.bounds.min[k] <= g.bounds.max[k]));
    assert_eq!(avatar.parts.start, [0, g.len() as u32]);
    if let Some(Harmonics { degree, coefficients }) = &avatar.harmonics {
        assert_eq!(coefficients.len(), g.len() * ((degree + 1).pow(2) - 1));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn changed_bytes_never_panic(
        encoding in prop_oneof![Just(Encoding::Ascii), Just(Encoding::Little), Just(Encoding::Big)],
        degree in 0usize..4,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..12),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = Table::new(9, 3, degree).bytes(encoding);
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(avatar) = read(&bytes) {
            keeps_the_rules(&avatar);
        }
    }

    #[test]
    fn headers_of_nonsense_never_panic(lines in prop::collection::vec(
        prop_oneof!["format (ascii|binary_little_endian) 1\\.0", "element (vertex|face|a) [0-9]{1,20}",
            "property (float|double|uchar|list uchar int) (x|y|z|opacity|rot_0|f_rest_[0-9]{1,3})", "[ -~]{0,30}", "end_header"], 0..30)) {
        let bytes = format!("ply\n{}\nend_header\n1 2 3 4 5 6 7 8 9\n", lines.join("\n"));
        prop_assert!(read(bytes.as_bytes()).is_err());
    }

    #[test]
    fn changed_cameras_never_panic(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6)) {
        let mut bytes = CAMERAS.as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Ok(cameras) = cameras::parse(&bytes, DAffine3::from_mat3(DMat3::IDENTITY)) {
            prop_assert!(cameras.iter().all(|camera| camera.view.is_finite()));
        }
    }
}
