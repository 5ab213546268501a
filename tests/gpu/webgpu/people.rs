//! Different people in one scene with the WebGPU backend natively: against the reference.

use super::open;
use crate::{
    common::gpu::Raster::{self, Quads, SharedTiles},
    stages::people::{SIZE, camera, cast, expected, people, posed, poses},
};
use effigy_core::{
    avatar::Avatar,
    frame::{AvatarId, Person, RendererOptions},
    scene::{Camera, FrameImage},
};
use effigy_measure::error;
use effigy_render::webgpu::{Error, Renderer};
use glam::DVec3;

fn options(raster: Raster) -> RendererOptions {
    RendererOptions {
        instances: 4,
        ..raster.options(open().name(), SIZE)
    }
}

fn add(renderer: &mut Renderer, avatar: &Avatar) -> AvatarId {
    let id = renderer.add_avatar(avatar).unwrap();
    assert_eq!(renderer.upload(id, avatar), Ok(true));
    id
}

fn draw(renderer: &mut Renderer, people: &[Person], camera: &Camera) -> FrameImage {
    renderer.draw_scene(people, camera).unwrap();
    let image = renderer.read_image().unwrap();
    renderer.gpu().check().unwrap();
    image
}

/// The smallest first, so that buffers grow; while the camera moves and while they do.
fn different_people_are_those_of_the_reference(raster: Raster) {
    let [_, large, lit, small] = cast();
    let cast = [small, large, lit];
    let mut renderer = Renderer::new(&open(), &cast[0], options(raster)).unwrap();
    let mut ids = vec![AvatarId::FIRST];
    let still = poses(&cast);
    draw(&mut renderer, &people(&ids, &still), &camera(0.4));
    for avatar in &cast[1..] {
        ids.push(add(&mut renderer, avatar));
    }
    let mut moved = still.clone();
    moved[1] = posed(&cast[1], 9, DVec3::new(0.2, 0.0, 0.1));
    for (poses, yaw) in [(&still, 0.4), (&still, 0.5), (&still, 0.6), (&moved, 2.0)] {
        let camera = camera(yaw);
        let image = draw(&mut renderer, &people(&ids, poses), &camera);
        let error = error::between(&image, &expected(&cast, poses, &camera, false)).covered;
        assert!(
            error.pixels > 5000 && error.psnr_db >= 47.0,
            "{yaw}: {error:?}"
        );
    }
    assert!(renderer.remove_avatar(ids[2]) && !renderer.remove_avatar(ids[2]));
    assert!(matches!(
        renderer.draw_scene(&people(&ids, &still), &camera(0.4)),
        Err(Error::Unusable(_))
    ));
    let image = draw(&mut renderer, &people(&ids[..2], &still), &camera(0.4));
    let expected = expected(&cast[..2], &still, &camera(0.4), false);
    let error = error::between(&image, &expected).covered;
    assert!(error.psnr_db >= 47.0, "{error:?}");
}

tests! {
    different_people_are_those_of_the_reference[Quads],
    different_people_are_those_of_the_reference[SharedTiles],
}
