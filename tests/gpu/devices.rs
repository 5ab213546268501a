//! Opening devices, and what happens when one can't be had or can't hold what it is asked to.

use crate::common::{self, Sizes, gpu, harness::not_run};
use effigy_core::{
    avatar::Avatar,
    frame::{RasterMethod, Stage, schedule::Equipment},
    layout::Control,
    scene::{Camera, Posed},
};
use effigy_render::vulkan::{
    Error, Gpu, GpuOptions, Renderer,
    memory::Buffer,
    shaders::MODULES,
    sort::SortVariant,
    statistics::{self, Executable},
};
use glam::DVec3;

fn an_unknown_device_is_answered_with_the_known_ones() {
    let device = gpu::gpu();
    let options = GpuOptions {
        device: Some("nonesuch 9000".into()),
        ..gpu::headless()
    };
    let message = Gpu::new(&options).err().unwrap().to_string();
    assert!(
        message.contains("nonesuch 9000") && message.contains(&device.probe.name),
        "{message}"
    );
}

fn a_device_is_found_by_number_and_by_part_of_its_name() {
    let device = gpu::gpu();
    let part: String = device
        .probe
        .name
        .chars()
        .take(5)
        .collect::<String>()
        .to_uppercase();
    for wanted in ["0", &part] {
        let found = Gpu::new(&GpuOptions::headless(Some(wanted.into()))).unwrap();
        assert_eq!(found.probe.name, device.probe.name, "{wanted}");
    }
}

/// What must be true of the statistics of all pipelines on any driver that has them.
fn assert_whole(device: &Gpu, executables: &[Executable]) {
    let onesweep =
        effigy_render::vulkan::sort::unsupported(SortVariant::OneSweep, device).is_none();
    let draws = |method| device.probe.lacks_for(method).is_none();
    let is_made = |file: &str| match file.rsplit_once('_').map_or(file, |(kernel, _)| kernel) {
        "sort/onesweep.comp" => onesweep,
        "raster/cooperative" => draws(RasterMethod::CooperativeTiles),
        "raster/shared" => draws(RasterMethod::SharedTiles),
        // Nothing that draws asks for those that measure a device.
        _ => !file.starts_with("rates/"),
    };
    for module in MODULES.iter().filter(|module| is_made(module.file)) {
        let of_module: Vec<_> = executables
            .iter()
            .filter(|made| made.shader == module.file)
            .collect();
        assert!(!of_module.is_empty(), "nothing on {}", module.file);
        for made in of_module {
            assert!(
                !made.statistics.is_empty() && !made.executable.is_empty(),
                "{made:?}"
            );
            assert!(
                made.statistics
                    .iter()
                    .all(|statistic| !statistic.name.is_empty()),
                "{made:?}"
            );
        }
    }
    for sort in executables
        .iter()
        .filter(|made| made.shader.starts_with("sort/"))
    {
        assert_eq!(
            sort.constants.split(' ').count(),
            11,
            "the sort's constants are not all there: {sort:?}"
        );
    }
}

fn a_small_avatar() -> Avatar {
    common::avatar(
        1,
        Sizes {
            gaussians: 100,
            ..Sizes::default()
        },
    )
}

fn a_device_tells_what_became_of_every_shader() {
    let device = gpu::gpu();
    if !device.probe.shader_statistics {
        not_run(format!("{} has no shader statistics", device.probe.name));
    }
    let (asked, executables) = statistics::all(&gpu::headless(), &a_small_avatar()).unwrap();
    assert_whole(&asked, &executables);
    let refused = asked.idle().unwrap_err();
    assert!(
        matches!(refused, Error::AskedOnly { .. }),
        "work is run on a device that was opened to be asked: {refused}"
    );
}

fn a_device_without_shader_statistics_says_so() {
    let device = gpu::gpu();
    if device.probe.shader_statistics {
        not_run(format!("{} has shader statistics", device.probe.name));
    }
    let error = statistics::all(&gpu::headless(), &a_small_avatar()).err();
    let message = error.unwrap().to_string();
    assert!(
        message.contains(&device.probe.name)
            && message.contains("VK_KHR_pipeline_executable_properties"),
        "{message}"
    );
}

fn a_buffer_larger_than_the_device_allows_is_refused_by_name() {
    let device = gpu::gpu();
    let size = u64::from(device.probe.limits.max_storage_buffer_range) + 1;
    let usage = ash::vk::BufferUsageFlags::STORAGE_BUFFER;
    let error = Buffer::new(
        &device,
        "too much",
        size,
        usage,
        gpu_allocator::MemoryLocation::GpuOnly,
    )
    .err()
    .unwrap();
    assert!(
        matches!(
            error,
            Error::TooLarge {
                what: "too much",
                ..
            }
        ),
        "{error}"
    );
}

fn memory_is_given_back() {
    let device = gpu::gpu();
    let avatar = common::avatar(
        1,
        Sizes {
            gaussians: 200,
            ..Sizes::default()
        },
    );
    let before = device.memory().0;
    for _ in 0..3 {
        let renderer = Renderer::new(&device, &avatar, gpu::options([300, 300])).unwrap();
        assert!(device.memory().0 > before + 300 * 300 * 8);
        drop(renderer);
        assert_eq!(
            device.memory().0,
            before,
            "bytes in use after dropping a renderer"
        );
    }
}

/// Arrays that contradict each other are an error of the renderer, not a panic.
fn avatars_that_contradict_themselves_are_refused() {
    let device = gpu::gpu();
    let mut avatar = common::avatar(1, Sizes::default());
    avatar.gaussians.node[3] = [u16::MAX; 3];
    let made = Renderer::new(&device, &avatar, gpu::options([100, 100]));
    let error = made.err().expect("a node that is not there is refused");
    let text = error.to_string();
    assert!(
        matches!(error, Error::Avatar(_)) && text.contains("`node` found 65535 at [3, 0]"),
        "{text}"
    );
}

/// Frames follow each other without waiting, with and without changes; the counts and the skipped
/// stages say so.
fn stages_whose_inputs_did_not_change_are_skipped() {
    let device = gpu::gpu();
    let avatar = common::avatar(1, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let mut renderer = Renderer::new(&device, &avatar, gpu::options([100, 100])).unwrap();
    let equipment = Equipment {
        sh: false,
        supersampling: false,
        method: renderer.raster().method(),
        skip: renderer.options().skip,
    };
    let expected: Vec<&str> = equipment.stages().map(Stage::name).collect();
    assert!(expected.starts_with(&["mlp"]) && expected.ends_with(&["raster"]));
    let camera = |yaw| Camera::orbit(DVec3::new(0.0, 1.0, 0.0), yaw, 0.0, 4.0, 0.7, [100, 100]);
    let mut frame = |posed: &Posed, camera: &Camera| {
        renderer.draw(posed, camera, None).unwrap();
        renderer.finish().unwrap();
        (renderer.report().clone(), renderer.read_image().unwrap())
    };
    let (all, first) = frame(&posed, &camera(0.0));
    assert!(
        all.skipped.is_empty() && all.counters.drawn > 100,
        "{all:?}"
    );
    let (none, same) = frame(&posed, &camera(0.0));
    assert_eq!(none.skipped, expected);
    assert!(same == first, "a frame without changes changed the image");
    let (view, turned) = frame(&posed, &camera(1.0));
    assert_eq!(view.skipped, ["mlp"]);
    assert!(turned != first);
    let other = Posed::new(&avatar, &common::pose(2, &avatar));
    assert!(frame(&other, &camera(1.0)).0.skipped.is_empty());
}

fn many_frames_in_flight_stay_in_order() {
    let device = gpu::gpu();
    let avatar = common::avatar(
        1,
        Sizes {
            gaussians: 300,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let mut renderer = Renderer::new(&device, &avatar, gpu::options([64, 64])).unwrap();
    for step in 0..50 {
        let camera = Camera::orbit(
            DVec3::new(0.0, 1.0, 0.0),
            f64::from(step),
            0.0,
            4.0,
            0.7,
            [64, 64],
        );
        renderer.draw(&posed, &camera, None).unwrap();
    }
    let camera = Camera::orbit(DVec3::new(0.0, 1.0, 0.0), 0.3, 0.0, 4.0, 0.7, [64, 64]);
    renderer.draw(&posed, &camera, None).unwrap();
    let reference = effigy_core::reference::render(&avatar, &posed, &camera);
    let error = effigy_measure::error::between(&renderer.read_image().unwrap(), &reference);
    assert!(error.covered.psnr_db > 54.0, "{:?}", error.covered);
    let control: Control = renderer.stages().unwrap().control;
    assert_eq!(control.key_count, 300);
}

tests! {
    an_unknown_device_is_answered_with_the_known_ones,
    a_device_is_found_by_number_and_by_part_of_its_name,
    a_device_tells_what_became_of_every_shader,
    a_device_without_shader_statistics_says_so,
    a_buffer_larger_than_the_device_allows_is_refused_by_name,
    memory_is_given_back,
    avatars_that_contradict_themselves_are_refused,
    stages_whose_inputs_did_not_change_are_skipped,
    many_frames_in_flight_stay_in_order,
}
