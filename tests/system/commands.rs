//! The program as its users run it: what each command writes, and what it says when it can't.

use crate::common::{self, gpu};
use effigy_measure::error;
use std::{
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    time::{Duration, Instant},
};

/// A run of `effigy`, or of `effigy-lab` where the arguments begin with its name.
fn command(folder: &Path, arguments: &str) -> Command {
    let (program, arguments) = match arguments.strip_prefix("effigy-lab ") {
        Some(arguments) => (common::lab(), arguments),
        None => (common::program(), arguments),
    };
    let mut command = Command::new(program);
    command
        .args(arguments.split_whitespace())
        .current_dir(folder)
        // Libraries of windows complain on standard error without it.
        .env("XDG_RUNTIME_DIR", folder)
        // Without a display, whatever the machine has.
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY");
    command
}

fn effigy(folder: &Path, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

/// Runs a command that must work and must not upset the validation layer.
fn works(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments);
    let (out, err) = (
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    assert!(output.status.success(), "effigy {arguments}: {err}");
    assert!(!err.contains("validation:"), "effigy {arguments}: {err}");
    out.into_owned()
}

/// Runs a command that must fail with one sentence, and at most a line of advice.
fn fails(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments);
    let err = String::from_utf8_lossy(&output.stderr).trim().to_string();
    assert!(!output.status.success(), "effigy {arguments} should fail");
    let lines: Vec<&str> = err.lines().collect();
    let advised = lines.len() == 2 && lines[1].starts_with("help: ");
    assert!(
        lines.len() == 1 || advised,
        "effigy {arguments}: one sentence expected, got: {err}"
    );
    assert!(err.starts_with("error: "), "{err}");
    err
}

/// Runs a command whose arguments must be refused, in as many lines as it takes.
fn fails_usage(folder: &Path, arguments: &str) -> String {
    let output = effigy(folder, arguments);
    assert!(!output.status.success(), "effigy {arguments} should fail");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn read_image(path: &Path) -> effigy_core::scene::FrameImage {
    let image = image::open(path).unwrap().to_rgba32f();
    effigy_core::scene::FrameImage {
        size: [image.width(), image.height()],
        pixels: image.pixels().map(|p| p.0).collect(),
    }
}

fn render_writes_the_demo_as_the_reference_draws_it() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    works(
        folder.path(),
        "render --size 320x400 --time 1.5 --out gpu.png",
    );
    works(
        folder.path(),
        "render --size 320x400 --time 1.5 --reference --out reference.png",
    );
    let [gpu, reference] =
        ["gpu.png", "reference.png"].map(|name| read_image(&folder.path().join(name)));
    assert_eq!(gpu.size, [320, 400]);
    let error = error::between(&gpu, &reference);
    // Both are rounded to 8 bits once more, over a background.
    assert!(error.whole.psnr_db > 50.0, "{error:?}");
    let background = reference.pixels[0];
    let drawn = reference
        .pixels
        .iter()
        .filter(|&&pixel| pixel != background)
        .count();
    assert!(
        drawn > 320 * 400 / 20,
        "only {drawn} pixels differ from the background"
    );
}

fn render_draws_several_as_the_reference_does() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "render small.avatar --motion small.motion --size 240x160 --time 0.4 --yaw 60";
    works(folder.path(), &format!("{what} --count 3 --out gpu.png"));
    works(
        folder.path(),
        &format!("{what} --count 3 --reference --out reference.png"),
    );
    works(folder.path(), &format!("{what} --out one.png"));
    let [gpu, reference, one] =
        ["gpu.png", "reference.png", "one.png"].map(|name| read_image(&folder.path().join(name)));
    assert!(
        error::between(&gpu, &reference).whole.psnr_db > 50.0
            && error::between(&one, &reference).whole.psnr_db < 30.0
    );
    assert!(fails_usage(folder.path(), "render --count 0").contains("--count"));
}

fn render_draws_a_scene_as_the_reference_does() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let scene = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let small = r#""avatar": "small.avatar", "motion": "small.motion""#;
    scene(
        "two.scene.json",
        &format!(
            r#"{{"people": [{{{small}, "at": [0.2, 0, 0], "turn": 90, "scale": 1.5}},
                {{"at": [-0.2, 0, 0.1], "start": 1.0}}, {{{small}, "start": 0.2}}]}}"#
        ),
    );
    let what = "render two.scene.json --size 240x160 --time 0.4";
    works(folder.path(), &format!("{what} --out gpu.png"));
    works(
        folder.path(),
        &format!("{what} --reference --out reference.png"),
    );
    works(
        folder.path(),
        "render --size 240x160 --time 0.4 --out one.png",
    );
    let [gpu, reference, one] =
        ["gpu.png", "reference.png", "one.png"].map(|name| read_image(&folder.path().join(name)));
    let error = error::between(&gpu, &reference).whole;
    assert!(error.psnr_db > 48.0, "{error:?}");
    assert!(error::between(&one, &reference).whole.psnr_db < 30.0);
    let person = format!("{{{small}}},");
    let crowd = format!(r#"{{"people": [{}{{}}]}}"#, person.repeat(1024));
    for (text, expected) in [
        (r#"{"people": []}"#, "0 people, expected 1 to 1024"),
        (crowd.as_str(), "1025 people, expected 1 to 1024"),
        (r#"{"people": [{"avatar": "gone.avatar"}]}"#, "gone.avatar"),
        (
            r#"{"people": [{}, {"avatar": "two.scene.json"}]}"#,
            "person 1: two.scene.json is a scene",
        ),
        (r#"{"people": [{"scale": 0}]}"#, "`scale` is 0"),
        (r#"{"people": [{"at": [1e9, 0, 0]}]}"#, "1000 m away"),
        (r#"{"people": [{"size": 1}]}"#, "unknown field `size`"),
        (r#"{"people": {}}"#, "expected a sequence"),
    ] {
        scene("bad.scene.json", text);
        let message = fails(folder.path(), "render bad.scene.json");
        assert!(
            message.contains(expected) && message.contains("bad.scene.json"),
            "{message}"
        );
    }
    let message = fails(folder.path(), "render two.scene.json --count 2");
    assert!(message.contains("--count"), "{message}");
}

fn a_range_of_frames_becomes_numbered_images() {
    let folder = tempfile::tempdir().unwrap();
    works(
        folder.path(),
        "render --size 64x96 --frames 3..6 --background none --out walk.png",
    );
    let images: Vec<_> = (3..6)
        .map(|frame| read_image(&folder.path().join(format!("walk-{frame:04}.png"))))
        .collect();
    assert!(images[0] != images[2], "the avatar does not move");
    assert!(
        images[0].pixels[0][3] == 0.0,
        "the background is not transparent"
    );
    let message = fails(folder.path(), "render --size 64x96 --frames 0..9999999");
    assert!(message.contains("9999999"), "{message}");
}

fn without_a_display_the_program_renders_a_turntable() {
    let folder = tempfile::tempdir().unwrap();
    let said = works(folder.path(), "");
    assert!(said.contains("effigy-turntable"), "{said}");
    assert_eq!(
        std::fs::read_dir(folder.path().join("effigy-turntable"))
            .unwrap()
            .count(),
        24
    );
}

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

fn bench_writes_what_it_measured_of_every_case() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "small.avatar --motion small.motion --size 160x160 --frames 13 --check 1";
    let said = works(
        folder.path(),
        &format!("bench {what} --case all --flip --json out.json --csv out.csv"),
    );
    let json = json(&folder.path().join("out.json"));
    assert!(
        json["device"]["name"].is_string()
            && json["program"]["date"].is_string()
            && json["options"]["skip"].is_string()
    );
    let cases = json["cases"].as_array().unwrap();
    let names: Vec<_> = cases
        .iter()
        .map(|case| case["name"].as_str().unwrap())
        .collect();
    assert!(
        names.starts_with(&[
            "full",
            "camera",
            "orbit",
            "expression",
            "static",
            "close",
            "four",
            "crowd",
            "flicker",
            "zoom",
            "far30",
            "far",
            "far120",
            "far240",
            "far480"
        ]),
        "{names:?}"
    );
    for case in cases {
        let name = case["name"].as_str().unwrap();
        assert!(
            said.contains(&format!("\n{name}: ")),
            "{name} is not printed: {said}"
        );
        assert!(
            case["frame_ms"]["median"].as_f64() > Some(0.0)
                && case["frame_ms"]["p95"].as_f64() >= case["frame_ms"]["median"].as_f64()
        );
        assert!(
            case["gpu_memory_bytes"].as_u64() > Some(0)
                && case["error"]["flip"].as_f64() < Some(if name == "crowd" { 0.3 } else { 0.1 }),
            "{name}: {}",
            case["error"]
        );
        // What is small is held against what the area of each pixel shows.
        let is_small = name.starts_with("far") || ["flicker", "zoom"].contains(&name);
        let least = match name {
            // An eighth of the Gaussians of avatars that are 8 px tall, for want of levels.
            "crowd" => 18.0,
            _ if is_small => 30.0,
            _ => 45.0,
        };
        assert!(
            case["error"]["psnr_db"].as_f64() > Some(least),
            "{name}: {}",
            case["error"]
        );
    }
    let ran = |case: usize, stage: &str| {
        let stages = cases[case]["stages"].as_array().unwrap();
        stages
            .iter()
            .find(|entry| entry["name"] == stage)
            .and_then(|entry| entry["ran"].as_f64())
            .unwrap()
    };
    for stage in ["mlp", "project", "sort", "raster"] {
        assert_eq!(
            [ran(0, stage), ran(4, stage)],
            [1.0, 0.0],
            "{stage} in motion and with nothing changed"
        );
    }
    let count = |case: usize, name: &str| cases[case]["counters"][name].as_f64().unwrap();
    let four = names.iter().position(|name| *name == "four").unwrap();
    for case in [0, 5, four] {
        let reasons: f64 = ["outside", "away", "faint", "degenerate"]
            .iter()
            .map(|name| count(case, name))
            .sum();
        let whole =
            count(case, "gaussians") * count(case, "avatars_culled") / count(case, "avatars");
        assert!(
            (reasons + whole - count(case, "culled")).abs() < 1e-6,
            "{reasons} and {whole} in whole avatars"
        );
    }
    assert_eq!([count(0, "avatars"), count(four, "avatars")], [1.0, 4.0]);
    assert_eq!(
        [ran(1, "mlp"), ran(1, "project")],
        [0.0, 1.0],
        "the camera alone moves"
    );
    assert!(
        cases[0]["counters"]["drawn"].as_f64() > Some(100.0)
            && cases[0]["bytes"].as_u64() > cases[0]["bytes_floor"].as_u64()
    );
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out.csv"))
            .unwrap()
            .lines()
            .count(),
        1 + cases.len()
    );
    let said = works(folder.path(), "compare out.json out.json");
    assert!(
        said.contains("frame_ms_median") && said.contains("1.000×") && !said.contains("note:"),
        "{said}"
    );
    std::fs::write(folder.path().join("old.json"), r#"{"device": "x"}"#).unwrap();
    let message = fails(folder.path(), "compare out.json old.json");
    assert!(
        message.contains("old.json") && message.contains("measure again"),
        "{message}"
    );
}

fn a_sweep_draws_time_against_error() {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "small.avatar --motion small.motion --size 96x96 --frames 12 --check 1 --rounds 1";
    let sweep = "--sweep exact,cutoff,rows,pose-rate --pareto front.svg --pareto front.png";
    let said = works(
        folder.path(),
        &format!("bench {what} {sweep} --json - --csv out.csv"),
    );
    let json: serde_json::Value = serde_json::from_str(&said).unwrap();
    let points = json["sweep"]["points"].as_array().unwrap();
    let psnr = |parameter: &str, value: &str| {
        let point = points
            .iter()
            .find(|point| point["parameter"] == parameter && point["value"] == value);
        point.unwrap_or_else(|| panic!("{parameter} {value} is missing: {points:?}"))["error"]["psnr_db"]
            .as_f64()
            .unwrap_or(f64::INFINITY)
    };
    let best = psnr("default", "");
    // Quads blend halves, exact or not, and without samples nothing averages what those lose.
    let least = match json["options"]["raster"].as_str() {
        Some("quads") => 40.0,
        _ => best,
    };
    assert!(best > 45.0 && psnr("exact", "yes") > least);
    assert!(
        psnr("rows", "0") < best - 3.0,
        "correctives that are gone are missed by nobody"
    );
    assert!(
        psnr("pose-rate", "10 Hz") < psnr("pose-rate", "30 Hz")
            && psnr("pose-rate", "30 Hz") < best,
        "old poses are not seen"
    );
    assert!(
        points.iter().any(|point| point["on_front"] == true)
            && points
                .iter()
                .all(|point| point["frame_ms"].as_f64() > Some(0.0))
    );
    let svg = std::fs::read_to_string(folder.path().join("front.svg")).unwrap();
    assert!(
        svg.contains("exact yes") && svg.contains("cutoff 8/255"),
        "names are missing"
    );
    assert_eq!(
        image::open(folder.path().join("front.png"))
            .unwrap()
            .width(),
        1400
    );
    let message = fails(folder.path(), "bench --case full --sweep pose-rate");
    assert!(
        message.contains("`full`") && message.contains("orbit"),
        "{message}"
    );
}

fn bench_measures_what_flickers() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "small.avatar --motion small.motion --spread 0 --json out.json --csv out.csv";
    let measured = ["flicker --size 720x720", "zoom --size 460x460"].map(|case| {
        let said = works(
            folder.path(),
            &format!("bench {what} --frames 9 --case {case}"),
        );
        let mut report = json(&folder.path().join("out.json"));
        (said, report["cases"][0].take())
    });
    let table = std::fs::read_to_string(folder.path().join("out.csv")).unwrap();
    assert!(table.contains("added_flicker_7_p999"), "{table}");
    let [(said, flicker), (said_of_zoom, zoom)] = measured;
    for case in [&flicker, &zoom] {
        let name = &case["name"];
        let steps = case["flicker"]["steps"].as_array().unwrap();
        let distances: Vec<_> = steps
            .iter()
            .map(|step| step["step"].as_u64().unwrap())
            .collect();
        assert_eq!(distances, [1, 7], "{name}");
        // In so few frames a zoom shrinks the body to a tenth over 7: hardly a pixel finds back.
        let is_far = |step: &serde_json::Value| name == "zoom" && step["step"] == 7;
        for step in steps {
            let mean = |of: &str| step[of]["mean"].as_f64().unwrap();
            assert!(
                (step["compared"].as_f64() > Some(0.1) || is_far(step))
                    && mean("reference") > 0.0
                    && mean("added") > 0.0
                    && (mean("drawn") - mean("reference")).abs() <= mean("added"),
                "{name}: {step}"
            );
            let residual = &step["drawn"];
            assert!(
                (residual["flip"].as_f64() > Some(0.0) || is_far(step))
                    && residual["mean"].as_f64() < residual["p999"].as_f64()
                    && residual["p999"].as_f64() <= residual["max"].as_f64(),
                "{name}: {residual}"
            );
        }
        assert!(
            case["error"]["psnr_db"].as_f64() > Some(20.0),
            "{name}: {}",
            case["error"]
        );
    }
    let sorted = &flicker["flicker"];
    assert!(
        sorted["sorting"]["psnr_db"].as_f64() > Some(20.0)
            && sorted["steps"][0]["sorting"]["added"]["mean"].as_f64() > Some(0.0),
        "{sorted}"
    );
    // From 451 to 20 px: drawn larger from the first frame on, more and more, without a switch.
    let pairs = zoom["flicker"]["pairs"].as_array().unwrap();
    let samples = |pair: &serde_json::Value| [0, 1].map(|k| pair["shown"][k]["samples"].as_f64());
    let samples: Vec<_> = pairs
        .iter()
        .filter(|pair| pair["to"].as_u64() == pair["from"].as_u64().map(|from| from + 1))
        .map(samples)
        .collect();
    let grows = |[from, to]: &[Option<f64>; 2]| from <= to;
    assert!(samples.iter().all(grows), "{samples:?}");
    let first = samples
        .iter()
        .filter_map(|pair| pair[0])
        .fold(4.0, f64::min);
    let last = samples
        .iter()
        .filter_map(|pair| pair[1])
        .fold(1.0, f64::max);
    assert!(first > 1.0 && first < 1.6 && last == 4.0, "{samples:?}");
    assert!(
        !said_of_zoom.contains("switch, frames ") && said.contains("sorted per pixel"),
        "{said} {said_of_zoom}"
    );
    works(
        folder.path(),
        &format!(
            "bench {what} --size 64x64 --frames 9 --rounds 1 --case flicker --sweep exact,pose-rate"
        ),
    );
    let report = json(&folder.path().join("out.json"));
    let added = |parameter: &str, value: &str| {
        let points = report["sweep"]["points"].as_array().unwrap();
        let point = points
            .iter()
            .find(|point| point["parameter"] == parameter && point["value"] == value)
            .unwrap_or_else(|| panic!("{parameter} {value} is missing: {points:?}"));
        point["flicker"]["steps"][1]["added"]["mean"]
            .as_f64()
            .unwrap()
    };
    assert!(
        added("pose-rate", "10 Hz") > 2.0 * added("default", ""),
        "poses that are held are seen by nobody"
    );
    assert!(added("exact", "yes") > 0.0);
}

fn bench_finds_the_worst_of_many_poses_and_views() {
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "small.avatar --motion small.motion --size 160x160 --frames 1 --check 0 --views 2 \
                --supersample 1";
    let spread = |options: &str| {
        let out = folder.path().join("out.json");
        let said = works(
            folder.path(),
            &format!("bench {what} {options} --json out.json"),
        );
        (said, json(&out)["spread"].clone())
    };
    let (said, default) = spread("--spread 3");
    assert!(said.contains("spread: 6 views of 160 × 160"), "{said}");
    assert_eq!(default["views"], 6);
    // No number: no pixel differs from what is drawn where nothing is skipped.
    let [worst, mean] = [&default["worst"]["psnr_db"], &default["mean_db"]]
        .map(|db| db.as_f64().unwrap_or(f64::INFINITY));
    assert!(worst > 40.0 && worst <= mean);
    assert_eq!(default["worst"]["clip"], "test clip 6");
    // Contributions that are cut, fewer Gaussians: they show.
    let (_, low) = spread("--spread 3 --cutoff 8 --detail 1/4");
    let low = low["worst"]["psnr_db"].as_f64().unwrap();
    println!("worst of 6 views: {worst} dB, with fewer Gaussians {low} dB");
    assert!(low < worst - 1.0, "{low} dB, the default {worst}");
    let (said, none) = spread("--spread 0");
    assert!(none.is_null() && !said.contains("spread:"));
}

fn an_exported_pose_is_drawn_and_measured_from_its_cameras() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    works(
        folder.path(),
        "export-ply --at 1.5 --out still.ply --cameras cams.json --views 3 --size 200x240",
    );
    works(
        folder.path(),
        "render still.ply --cameras cams.json --out still.png",
    );
    works(
        folder.path(),
        "render --time 1.5 --cameras cams.json --reference --out avatar.png",
    );
    for number in 0..3 {
        let [still, avatar] = ["still", "avatar"]
            .map(|name| read_image(&folder.path().join(format!("{name}-{number:04}.png"))));
        assert_eq!(still.size, [200, 240], "the cameras' own size");
        let error = error::between(&still, &avatar);
        assert!(error.whole.psnr_db > 50.0, "camera {number}: {error:?}");
    }
    works(
        folder.path(),
        "render still.ply --cameras cams.json --size 100x60 --out small.png",
    );
    assert_eq!(
        read_image(&folder.path().join("small-0002.png")).size,
        [100, 60]
    );
    let said = works(
        folder.path(),
        "bench still.ply --cameras cams.json --frames 3 --check 1",
    );
    assert!(said.contains("200 × 240"), "{said}");
    let said = works(folder.path(), "inspect still.ply");
    assert!(
        said.contains("splats      still") && said.contains("up          y"),
        "{said}"
    );
    works(
        folder.path(),
        "export-ply --uniform 0.003,0.9 --out balls.ply",
    );
    let said = works(folder.path(), "inspect balls.ply");
    assert!(said.contains("0.003 to 0.003, median 0.003"), "{said}");
    let message = fails(folder.path(), "render --cameras still.ply");
    assert!(
        message.contains("expected cameras.json as 3DGS or mmlphuman writes it"),
        "{message}"
    );
}

fn bad_input_is_answered_with_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let avatar = effigy_demo::avatar().unwrap().to_bytes().unwrap();
    std::fs::write(folder.path().join("cut.avatar"), &avatar[..100_000]).unwrap();
    let message = fails(folder.path(), "render cut.avatar");
    assert!(message.contains("cut.avatar"), "{message}");
    let message = fails(folder.path(), "render nowhere.avatar");
    assert!(message.contains("nowhere.avatar"), "{message}");
    let message = fails(folder.path(), "render --device nonesuch");
    assert!(
        message.contains("nonesuch") || message.contains("Vulkan"),
        "{message}"
    );
}

fn image_sizes_that_no_device_draws_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let message = fails(folder.path(), "render --size 100000x10");
    assert!(
        message.contains("100000") && message.contains("px a side"),
        "{message}"
    );
}

fn devices_lists_every_device_and_its_use() {
    let folder = tempfile::tempdir().unwrap();
    let text = works(folder.path(), "devices");
    assert!(
        text.contains("subgroup ballots") && text.contains("can serve"),
        "{text}"
    );
    let json: serde_json::Value =
        serde_json::from_str(&works(folder.path(), "devices --json")).unwrap();
    assert!(json[0]["name"].is_string() && json[0]["optional"]["timestamps"]["has"].is_boolean());
    works(folder.path(), "devices --json devices.json");
    assert_eq!(read_json(&folder.path().join("devices.json")), json);
}

/// What a backend can't do is not asked of it by a default or `--exact`, which Vulkan draws in the test
/// of sweeps.
fn each_backend_measures_and_draws_without_further_options() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    common::small_files(folder.path());
    let what = "small.avatar --motion small.motion --size 64x96";
    let defaults = [
        "bench --frames 4 --check 1 --spread 1 --json out.json",
        "render --out a.png",
    ];
    let exact = [
        "bench --exact --check 0 --spread 1 --frames 2",
        "bench --sweep exact --frames 1 --check 1 --rounds 1",
        "render --exact --out b.png",
    ];
    for (backend, exact) in [("vulkan", &exact[..0]), ("webgpu", &exact)] {
        for command in defaults.iter().chain(exact) {
            works(
                folder.path(),
                &format!("{command} {what} --backend {backend}"),
            );
        }
        let report = read_json(&folder.path().join("out.json"));
        assert!(report["spread"]["views"].as_u64() > Some(0), "{backend}");
        std::fs::remove_file(folder.path().join("out.json")).unwrap();
    }
    let said = fails_usage(folder.path(), &format!("render {what} --keys 32"));
    assert!(said.contains("leave it out: depth keys"), "{said}");
}

/// A budget of minutes leaves out what would take longer, and says what is left meanwhile.
fn sorts_are_measured_as_long_as_is_said() {
    gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let begun = Instant::now();
    let output = effigy(
        folder.path(),
        "effigy-lab bench-sort --sort per-thread --keys 16,32 --minutes 0.12 --json out.json",
    );
    let [said, progress] =
        [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(output.status.success(), "{progress}");
    let took = begun.elapsed();
    assert!(took < Duration::from_secs(40));
    assert!(
        said.contains("left out: ") && said.contains("--minutes 0.12"),
        "{said}"
    );
    // Nothing is said in the first 5 s, after which a slow machine may have no time for another.
    let is_short = took < Duration::from_secs(8);
    assert!(is_short || progress.contains(" left"), "{progress}");
    let rows = read_json(&folder.path().join("out.json"))["rows"]
        .as_array()
        .unwrap()
        .len();
    assert!((1..16).contains(&rows), "{rows} of 16 sorts");
}

fn read_json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// The step of a bundle whose time is over is killed. Each command measures at least 8 things.
fn what_is_killed_leaves_what_it_had_measured() {
    for (arguments, list) in [
        (
            "effigy-lab bench-sort --sort per-thread --keys 16 --runs 9 --json",
            "rows",
        ),
        (
            "effigy-lab bench-device --size 512x512 --max-copy 64 --min-ms 400 --json",
            "copies",
        ),
        (
            "bench --size 96x96 --frames 4 --check 1 --spread 0 --sort per-thread \
             --case full,camera,orbit,expression,static,close,far,four --json",
            "cases",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("part.json");
        let mut child = command(folder.path(), &format!("{arguments} part.json"))
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        while !path.exists() && begun.elapsed() < Duration::from_secs(100) {
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let measured = read_json(&path)[list].as_array().unwrap().len();
        assert!((1..8).contains(&measured), "{arguments}: {measured}");
    }
}

/// Ctrl-C, or the end of a step's time, while a sort is under trial.
#[cfg(unix)]
fn what_is_ended_while_it_tests_sorts_refuses_none() {
    gpu::drawing();
    for (arguments, signal, code) in [
        (
            "bench --size 96x96 --frames 1 --check 0 --spread 0",
            "-INT",
            None,
        ),
        ("devices", "-TERM", None),
        ("soak --size 64x80", "-TERM", Some(130)),
    ] {
        let folder = tempfile::tempdir().unwrap();
        common::small_files(folder.path());
        let cache = folder.path().join("cache");
        let record = || {
            let files = std::fs::read_dir(cache.join("effigy")).ok()?;
            let mut files = files.filter_map(|file| Some(file.ok()?.path()));
            let of_sorts = |path: &PathBuf| {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                name.starts_with("sort-")
            };
            let text = std::fs::read_to_string(files.find(of_sorts)?).ok()?;
            serde_json::from_str::<serde_json::Value>(&text).ok()
        };
        let source = match arguments {
            "devices" => "",
            _ => "small.avatar --motion small.motion",
        };
        // Twice: of a program that ended twice in a trial, the second time would count. A fast
        // device may be done before the signal comes.
        let (mut ended, mut rounds) = (0, 0);
        while ended < 2 {
            rounds += 1;
            assert!(rounds < 10, "{arguments}: its trials are always done");
            let mut child = command(folder.path(), &format!("{arguments} {source}"))
                .env("XDG_CACHE_HOME", &cache)
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            while !record().is_some_and(|record| record["trying"].is_array()) {
                let ended = child.try_wait().unwrap();
                assert!(ended.is_none(), "{arguments}: it tested nothing, {ended:?}");
                std::thread::sleep(Duration::from_millis(1));
            }
            let id = child.id().to_string();
            let killed = Command::new("kill").args([signal, &id]).status().unwrap();
            let status = child.wait().unwrap();
            if status.success() || !killed.success() {
                std::fs::remove_dir_all(&cache).unwrap();
                continue;
            }
            ended += 1;
            assert_eq!(status.code(), code, "{arguments}: {status}");
            let record = record().unwrap();
            assert_eq!(record["trying"], serde_json::Value::Null, "{arguments}");
            let tried = record["tried"].as_array().unwrap();
            assert!(tried.iter().all(|tried| tried[1] != "Unfinished"));
        }
    }
}

fn shader_statistics_are_a_table_or_a_sentence() {
    let device = gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(common::lab())
        .args(["shader-stats", "--csv", "stats.csv"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.success(), device.probe.shader_statistics);
    if !device.probe.shader_statistics {
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(
            message.contains("VK_KHR_pipeline_executable_properties"),
            "{message}"
        );
        assert!(!folder.path().join("stats.csv").exists());
        return;
    }
    let table = String::from_utf8_lossy(&output.stdout);
    assert!(table.starts_with(&device.probe.name), "{table}");
    let rows = std::fs::read_to_string(folder.path().join("stats.csv")).unwrap();
    for shader in [
        "raster/quads.vert",
        "raster/quads.frag",
        "project/project.comp",
    ] {
        assert!(
            table.lines().any(|line| line.starts_with(shader)) && rows.contains(shader),
            "nothing on {shader}: {table}"
        );
    }
}

fn a_capture_without_renderdoc_says_how_to_attach_it() {
    let folder = tempfile::tempdir().unwrap();
    let error = fails(folder.path(), "capture --size 64x64");
    assert!(
        error.contains("RenderDoc is not attached")
            && error.contains("renderdoccmd capture effigy capture"),
        "{error}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

fn the_version_names_the_program() {
    let said = works(Path::new("."), "--version");
    assert_eq!(said, concat!("effigy ", env!("CARGO_PKG_VERSION"), "\n"));
}

tests! {
    the_version_names_the_program: no_device,
    each_backend_measures_and_draws_without_further_options,
    sorts_are_measured_as_long_as_is_said,
    render_writes_the_demo_as_the_reference_draws_it,
    render_draws_several_as_the_reference_does,
    render_draws_a_scene_as_the_reference_does,
    a_range_of_frames_becomes_numbered_images,
    without_a_display_the_program_renders_a_turntable,
    bench_writes_what_it_measured_of_every_case,
    bench_measures_what_flickers,
    bench_finds_the_worst_of_many_poses_and_views,
    a_sweep_draws_time_against_error,
    an_exported_pose_is_drawn_and_measured_from_its_cameras,
    bad_input_is_answered_with_one_sentence: no_device,
    image_sizes_that_no_device_draws_are_refused,
    devices_lists_every_device_and_its_use,
    what_is_killed_leaves_what_it_had_measured,
    #[cfg(unix)]
    what_is_ended_while_it_tests_sorts_refuses_none,
    shader_statistics_are_a_table_or_a_sentence,
    a_capture_without_renderdoc_says_how_to_attach_it,
}
