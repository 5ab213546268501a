//! The task of a benchmark: what it draws and for how long, in every case.

use super::{
    backend::BenchDevice,
    report::{BenchReport, SCHEMA},
    scene::SceneInputs,
};
use crate::{
    report::{OptionsReport, Program, Subject},
    setting::RenderSetting,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    scene::Camera,
};

/// A benchmark to run.
#[derive(Clone, Copy)]
pub struct BenchTask<'a> {
    /// The avatar to draw.
    pub avatar: &'a Avatar,
    /// The clip that moves it.
    pub player: &'a Player,
    /// See [`SceneInputs::cameras`].
    pub cameras: &'a [Camera],
    /// Frames to time, at least 1.
    pub frames: usize,
    /// Views around the avatar, at least 1.
    pub views: usize,
    /// How many of the frames to compare with the reference.
    pub checked: usize,
    /// Whether to compute FLIP of them too.
    pub flip: bool,
    /// Frames to draw before the clock starts.
    pub warm_up: usize,
}

impl<'a> BenchTask<'a> {
    /// The inputs of a case's scenes under a setting.
    pub fn scene_inputs(&self, setting: &RenderSetting) -> SceneInputs<'a> {
        SceneInputs {
            avatar: self.avatar,
            player: self.player,
            size: setting.options.size,
            cameras: self.cameras,
            frames: self.frames,
            views: self.views,
            hold: setting.hold,
        }
    }

    /// A report without cases. `command` is the command line.
    pub fn report(
        &self,
        device: &BenchDevice,
        setting: &RenderSetting,
        command: Vec<String>,
    ) -> BenchReport {
        BenchReport {
            schema: SCHEMA.to_owned(),
            program: Program::current(command),
            device: device.describe(),
            avatar: Subject::new(self.avatar, self.player),
            size: setting.options.size,
            options: OptionsReport::new(setting),
            cases: Vec::new(),
            spread: None,
            sweep: None,
        }
    }
}
