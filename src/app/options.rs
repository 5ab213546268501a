//! Options of the viewer.

use crate::{
    dropped::OpenFiles,
    file_list::FileList,
    quality_control::QualityControl,
    scene::{BACKGROUND, BehindImage},
};
use effigy_render::vulkan::{GpuOptions, RendererOptions};
use std::{path::PathBuf, sync::Arc};

/// Options that a viewer is started with.
pub struct ViewerOptions {
    /// Which device to open, and how.
    pub gpu: GpuOptions,
    /// How to draw at full quality. `size` is the window's initial size, px.
    pub renderer: RendererOptions,
    /// Open the window in full screen.
    pub full_screen: bool,
    /// Colour behind the avatar: display-referred RGB, 0 to 1.
    pub background: [f32; 3],
    /// A picture behind the avatar, shown first; B goes on to colours.
    pub picture: Option<BehindImage>,
    /// Another thread of the program makes the avatar: [`Display::live`](crate::Display::live). It
    /// starts paused and no ways to draw are timed, since both would take the device from it.
    pub live: bool,
    /// Draw continuously, and quit after this many frames.
    pub frames: Option<u32>,
    /// Losses to simulate, for tests: no driver loses anything on demand.
    pub rehearse: Vec<Rehearsal>,
    /// Avatars to choose from in the panel.
    pub file_list: FileList,
    /// How to open files that are dropped on the window. None: they are ignored.
    pub opener: Option<Arc<dyn OpenFiles>>,
    /// Index in `file_list` of the avatar to load and show once the viewer runs.
    pub first: Option<usize>,
    /// Folders for screenshots, in order of preference.
    pub folders: Vec<PathBuf>,
    /// A message that the panel shows at the start.
    pub message: Option<String>,
    /// The report of an earlier crash, which the panel offers to share.
    pub crash_report: Option<String>,
    /// Survey the device once the first frame is drawn, in so many minutes.
    pub survey: Option<f64>,
    /// How to hold a frame rate. None: full quality at any frame rate.
    pub quality_control: Option<QualityControl>,
    /// File for a timeline of host and device, written at the end.
    pub trace: Option<PathBuf>,
}

impl ViewerOptions {
    /// The options of a plain viewer: the first device that can present to the window, full
    /// quality, a light background.
    pub fn new(renderer: RendererOptions) -> Self {
        Self {
            gpu: effigy_runtime::cache::headless(None),
            renderer,
            full_screen: false,
            background: BACKGROUND,
            picture: None,
            live: false,
            frames: None,
            rehearse: Vec::new(),
            file_list: FileList::default(),
            opener: None,
            first: None,
            folders: crate::screenshot::folders(),
            message: None,
            crash_report: None,
            survey: None,
            quality_control: None,
            trace: None,
        }
    }
}

/// Losses that a driver can report while a window is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DriverLoss {
    /// The window's surface.
    Surface,
    /// The device, with everything on it.
    Device,
    /// Not lost: the device has too little memory for an avatar.
    Memory,
}

/// A loss to simulate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rehearsal {
    /// The kind of loss.
    pub loss: DriverLoss,
    /// The number of the frame before which a surface or device is lost. For
    /// [`DriverLoss::Memory`], how many devices are opened before the one that has too little
    /// memory.
    pub number: u32,
}
