//! Shows a text without the GPU, on phones that can't run the viewer.

use super::{java, log};
use crate::font;
use std::{mem::MaybeUninit, time::Duration};
use tracing::Level;
use winit::platform::android::activity::{
    AndroidApp, InputStatus, MainEvent, PollEvent,
    input::{InputEvent, KeyAction, Keycode},
    ndk::hardware_buffer_format::HardwareBufferFormat,
};

/// How often to check whether the activity still exists.
const CHECK: Duration = Duration::from_millis(500);
/// Pixels an inch of a screen with one px a point.
const DENSITY: f32 = 160.0;

/// Explains an error to the phone's owner.
pub fn explanation(error: &anyhow::Error) -> String {
    use effigy_render::vulkan::Error;
    let why = match error.downcast_ref::<Error>() {
        Some(Error::NoLoader(_) | Error::NoDevice) => {
            "This device has no Vulkan driver. Effigy needs Vulkan 1.1.".into()
        }
        Some(Error::Unsupported { device, missing }) => {
            format!("{device} can't draw it: {missing}.")
        }
        Some(error @ (Error::NoTriangles { .. } | Error::NoSort { .. })) => format!("{error}."),
        _ => {
            return format!(
                "Effigy has stopped.\n\n{error:#}\n\nThe log has more: adb logcat -s effigy"
            );
        }
    };
    format!(
        "Effigy can't run here.\n\n{why}\n\nAn update of the system may help. The log has more: adb logcat -s effigy"
    )
}

/// Shows a text until the activity is destroyed.
pub fn show(app: &AndroidApp, text: &str) {
    log::write(Level::ERROR, text);
    draw(app, text);
    let mut over = false;
    while !over && !java::is_destroyed(app) {
        app.poll_events(Some(CHECK), |event| match event {
            PollEvent::Main(MainEvent::Destroy) => over = true,
            PollEvent::Main(
                MainEvent::InitWindow { .. }
                | MainEvent::WindowResized { .. }
                | MainEvent::RedrawNeeded { .. }
                | MainEvent::ConfigChanged { .. },
            ) => draw(app, text),
            PollEvent::Main(MainEvent::InputAvailable) => handle_input(app),
            _ => {}
        });
    }
}

/// Handles the back key, and ignores all other input.
fn handle_input(app: &AndroidApp) {
    let Ok(mut events) = app.input_events_iter() else {
        return;
    };
    while events.next(|event| match event {
        InputEvent::KeyEvent(key) if key.key_code() == Keycode::Back => {
            if key.action() == KeyAction::Up {
                java::back(app);
            }
            InputStatus::Handled
        }
        _ => InputStatus::Unhandled,
    }) {}
}

fn draw(app: &AndroidApp, text: &str) {
    let Some(window) = app.native_window() else {
        return;
    };
    let scale = app
        .config()
        .density()
        .map_or(2.0, |density| density as f32 / DENSITY);
    // 0 × 0 is the window's own size.
    if let Err(error) =
        window.set_buffers_geometry(0, 0, Some(HardwareBufferFormat::R8G8B8A8_UNORM))
    {
        return log::write(Level::WARN, &format!("the window takes no pixels: {error}"));
    }
    match window.lock(None) {
        Ok(mut buffer) => {
            let size = [buffer.width() as u32, buffer.height() as u32];
            let image = font::draw_page(text, size, scale);
            let row = 4 * image.width() as usize;
            let Some(lines) = buffer.lines() else { return };
            for (line, drawn) in lines.zip(image.as_raw().chunks_exact(row.max(4))) {
                for (to, from) in line.iter_mut().zip(drawn) {
                    *to = MaybeUninit::new(*from);
                }
            }
        }
        Err(error) => log::write(
            Level::WARN,
            &format!("the window can't be drawn to: {error}"),
        ),
    }
}
