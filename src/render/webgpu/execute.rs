//! Runs a frame's schedule: records its passes and stages into a command encoder. WebGPU orders
//! memory by itself, so barriers are passed over.

use super::{
    device::Gpu,
    frame_in_flight::{FrameInFlight, Writes},
    held::HeldAvatar,
    kernel::block_offset,
    raster::Draw,
    shared::SharedStages,
};
use bytemuck::bytes_of;
use effigy_core::{
    frame::{
        AvatarId, ByAvatar, FramePlan, FrameSchedule,
        passes::{Pass, RenderTarget},
        schedule::{ScheduleStep, ScheduledStage},
    },
    layout::{Control, QUADS_PER_INSTANCE},
};

/// What holds of every schedule.
const SCHEDULED: &str = "a renderer schedules only stages that it has";

/// What passes are recorded with: a renderer's stages, and where a frame's data lies.
pub struct Executor<'a> {
    pub gpu: &'a Gpu,
    pub avatars: &'a ByAvatar<HeldAvatar>,
    pub shared: &'a SharedStages,
    pub plan: &'a FramePlan<'a>,
    /// The draw into the frame's image.
    pub image: Draw<'a>,
    /// The draw into the atlas, if there is one.
    pub atlas: Option<Draw<'a>>,
}

/// Counts before anything is sorted.
pub fn control(key_count: u32) -> Control {
    Control {
        index_count: 6 * QUADS_PER_INSTANCE,
        key_count,
        ..Control::default()
    }
}

/// The part of an encoder that a stage's pass is recorded in.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PassScope {
    /// The encoder itself: copies and fills.
    Encoder,
    /// A compute pass, with the passes beside it that run in one too.
    Compute,
    /// Render passes of its own, or more than one pass.
    Own,
}

fn scope(pass: &Pass) -> PassScope {
    match pass {
        Pass::SetKeyCount { .. }
        | Pass::ClearCounts
        | Pass::ClearTileLists
        | Pass::KeepCounts
        | Pass::ReadCounts => PassScope::Encoder,
        Pass::Mlp { .. }
        | Pass::Sh { .. }
        | Pass::Project { .. }
        | Pass::Sort
        | Pass::Binning { .. }
        | Pass::Saturation
        | Pass::RasterTiles { .. } => PassScope::Compute,
        Pass::Bin { .. } | Pass::RasterQuads { .. } | Pass::Resolve { .. } => PassScope::Own,
    }
}

impl Executor<'_> {
    /// Records a schedule, in its order. The frame in flight must have begun, and nothing of it be
    /// submitted.
    pub fn execute(
        &self,
        in_flight: &mut FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        schedule: &FrameSchedule,
    ) {
        let SharedStages {
            control,
            splats,
            blocks,
            ..
        } = self.shared;
        let mut is_second = false;
        for step in &schedule.steps {
            match step {
                ScheduleStep::Skip(stage, _) => in_flight.skip(*stage),
                ScheduleStep::Command(command) => match command.pass() {
                    // It stands between the layers.
                    Some(Pass::KeepCounts) => {
                        in_flight.keep_counts(encoder, control, splats);
                        blocks.second_settings(encoder);
                        is_second = true;
                    }
                    Some(Pass::SetKeyCount { .. }) if is_second => {
                        blocks.second_control(encoder, control);
                    }
                    Some(pass) => self.encode(encoder, pass),
                    None => {}
                },
                ScheduleStep::Stage(stage) => self.stage(in_flight, encoder, stage),
            }
        }
    }

    /// Its first timed pass writes when the stage began, its last one when it ended.
    fn stage(
        &self,
        in_flight: &mut FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        scheduled: &ScheduledStage,
    ) {
        let [begin, end] = in_flight.stage(scheduled.stage);
        let passes: Vec<&Pass> = scheduled.passes().collect();
        let shared =
            |a: &&Pass, b: &&Pass| [a, b].map(|pass| scope(pass)) == [PassScope::Compute; 2];
        let groups: Vec<&[&Pass]> = passes.chunk_by(shared).collect();
        let timed = |group: &&[&Pass]| scope(group[0]) != PassScope::Encoder;
        let first = groups.iter().position(timed);
        let last = groups.iter().rposition(timed);
        for (at, group) in groups.into_iter().enumerate() {
            let writes = [
                begin.filter(|_| Some(at) == first),
                end.filter(|_| Some(at) == last),
            ];
            match scope(group[0]) {
                PassScope::Encoder => self.encode(encoder, group[0]),
                PassScope::Own => self.own(in_flight, encoder, group[0], writes),
                PassScope::Compute => {
                    let mut compute = in_flight.pass(encoder, scheduled.stage, writes);
                    for pass in group {
                        self.dispatch(&mut compute, pass);
                    }
                }
            }
        }
    }

    /// An avatar and its kernels.
    fn held(&self, avatar: AvatarId) -> &HeldAvatar {
        self.avatars.get(avatar).expect(SCHEDULED)
    }

    /// The draw into a layer's image.
    fn draw(&self, target: RenderTarget) -> &Draw<'_> {
        match target {
            RenderTarget::Atlas => self.atlas.as_ref().expect(SCHEDULED),
            RenderTarget::Image => &self.image,
        }
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, pass: &Pass) {
        match *pass {
            Pass::SetKeyCount { keys } => {
                // Before all that the encoder holds, and after the frames before.
                self.gpu
                    .queue
                    .write_buffer(&self.shared.control, 0, bytes_of(&control(keys)));
            }
            Pass::ClearCounts => self.shared.splats.clear(encoder),
            // The counts are copied where the frame is submitted.
            Pass::ReadCounts => {}
            Pass::KeepCounts
            | Pass::Mlp { .. }
            | Pass::Sh { .. }
            | Pass::Project { .. }
            | Pass::Sort
            | Pass::ClearTileLists
            | Pass::Binning { .. }
            | Pass::Bin { .. }
            | Pass::Saturation
            | Pass::RasterTiles { .. }
            | Pass::RasterQuads { .. }
            | Pass::Resolve { .. } => unreachable!("{pass:?} is part of a stage and no copy"),
        }
    }

    fn own(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        pass: &Pass,
        writes: Writes,
    ) {
        let raster = &self.shared.raster;
        match pass {
            Pass::Bin { target } => {
                let draw = self.draw(*target);
                raster.record_bins(in_flight, encoder, draw, writes);
            }
            Pass::RasterQuads { tested, target } => {
                let draw = self.draw(*target);
                let control = &self.shared.control;
                raster.record_quads(in_flight, encoder, draw, control, *tested, writes);
            }
            Pass::Resolve { clear } => {
                let slots = &self.plan.atlas.as_ref().expect(SCHEDULED).slots;
                raster.record_resolve(in_flight, encoder, &self.image, slots, *clear, writes);
            }
            _ => unreachable!("{pass:?} has no passes of its own: `place` says so"),
        }
    }

    fn dispatch(&self, compute: &mut wgpu::ComputePass, pass: &Pass) {
        let SharedStages { sort, raster, .. } = self.shared;
        match *pass {
            Pass::Mlp {
                instance,
                avatar,
                parts,
            } => {
                let mlp = &self.held(avatar).mlp;
                mlp.record(compute, block_offset(instance), parts);
            }
            Pass::Sh {
                instance,
                avatar,
                model,
                gaussians,
            } => {
                let sh = self.held(avatar).sh.as_ref().expect(SCHEDULED);
                sh.record(compute, block_offset(instance), model, gaussians);
            }
            Pass::Project {
                instance,
                avatar,
                model,
                gaussians,
                skinning,
            } => {
                let project = &self.held(avatar).project;
                let block = block_offset(instance);
                project.record(compute, block, model, gaussians, skinning);
            }
            Pass::Sort => sort.record(compute),
            Pass::Saturation => raster.record_saturation(compute, &self.image),
            Pass::RasterTiles { target, .. } => {
                raster.record_tiles(compute, self.draw(target));
            }
            _ => unreachable!("{pass:?} is no kernel: `place` says so"),
        }
    }
}
