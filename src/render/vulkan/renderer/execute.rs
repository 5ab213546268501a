//! Runs a frame's schedule: records its passes, barriers and stages into a command buffer.

use super::{
    held::{AvatarKernels, HeldAvatar},
    shared::SharedStages,
};
use crate::vulkan::{
    commands::{control::set_control, frame_in_flight::FrameInFlight},
    device::recording::Recording,
    memory::Scope,
    raster::{draw::Draw, quad_pass::OnePassTarget},
};
use ash::vk::{AccessFlags, PipelineStageFlags};
use effigy_core::frame::{
    AvatarId, ByAvatar, FramePlan, FrameSchedule,
    passes::{Pass, RenderTarget, Stage},
    resource::PipelineStages,
    schedule::{FrameCommand, ScheduleStep},
};

/// What a barrier waits for: the stages, and what they wrote.
fn before(stages: PipelineStages) -> Scope {
    scope(
        stages,
        AccessFlags::TRANSFER_WRITE,
        AccessFlags::SHADER_WRITE,
        AccessFlags::empty(),
    )
}

/// What a barrier holds back: the stages, and whatever they do with memory.
fn after(stages: PipelineStages) -> Scope {
    scope(
        stages,
        AccessFlags::TRANSFER_READ | AccessFlags::TRANSFER_WRITE,
        AccessFlags::SHADER_READ | AccessFlags::SHADER_WRITE,
        AccessFlags::SHADER_READ,
    )
}

fn scope(
    stages: PipelineStages,
    transfer: AccessFlags,
    compute: AccessFlags,
    graphics: AccessFlags,
) -> Scope {
    let mut scope = Scope::new(PipelineStageFlags::empty(), AccessFlags::empty());
    let mut add = |stage, flags, access| {
        if stages.contains(stage) {
            scope.stages |= flags;
            scope.access |= access;
        }
    };
    add(
        PipelineStages::TRANSFER,
        PipelineStageFlags::TRANSFER,
        transfer,
    );
    add(
        PipelineStages::COMPUTE,
        PipelineStageFlags::COMPUTE_SHADER,
        compute,
    );
    add(
        PipelineStages::VERTEX,
        PipelineStageFlags::VERTEX_SHADER,
        graphics,
    );
    add(
        PipelineStages::FRAGMENT,
        PipelineStageFlags::FRAGMENT_SHADER,
        graphics,
    );
    let arguments = if graphics.is_empty() {
        AccessFlags::empty()
    } else {
        AccessFlags::INDIRECT_COMMAND_READ
    };
    add(
        PipelineStages::INDIRECT,
        PipelineStageFlags::DRAW_INDIRECT,
        arguments,
    );
    // Render passes order what is blended into an image.
    scope
}

/// What holds of every schedule.
const SCHEDULED: &str = "a renderer schedules only stages that it has";

/// What passes are recorded with: a renderer's stages, and where a frame's data lies.
pub(super) struct Executor<'a> {
    pub avatars: &'a ByAvatar<HeldAvatar>,
    pub shared: &'a SharedStages,
    pub plan: &'a FramePlan<'a>,
    /// Index of the frame in flight.
    pub frame: usize,
    /// Where quads go in the render pass that draws them.
    pub screen: Option<&'a OnePassTarget<'a>>,
    /// The draw into the frame's image.
    pub image: Draw<'a>,
    /// The draw into the atlas, if there is one.
    pub atlas: Option<Draw<'a>>,
}

impl Executor<'_> {
    /// Records a schedule into a frame in flight, which must be recording.
    pub fn execute(&self, in_flight: &mut FrameInFlight, schedule: &FrameSchedule) {
        let count = self.image.count;
        for step in &schedule.steps {
            match step {
                ScheduleStep::Skip(stage, _) => in_flight.skip(stage.name()),
                ScheduleStep::Command(FrameCommand::Run(Pass::KeepCounts)) => {
                    // SAFETY: the frame is recording; the renderer drops the buffers after the
                    // frames in flight.
                    unsafe { in_flight.keep_counts(self.shared.count_sources()) };
                }
                ScheduleStep::Command(command) => {
                    in_flight.record(|commands| self.record(commands, command));
                }
                ScheduleStep::Stage(stage) => {
                    let name = stage.stage.name();
                    let record = |commands: Recording| {
                        for command in &stage.commands {
                            self.record(commands, command);
                        }
                    };
                    if stage.draws_quads() {
                        in_flight.drawing(name, count, record);
                        continue;
                    }
                    match stage.stage {
                        Stage::Saturation if count => in_flight.counts_samples(),
                        Stage::Raster if count => in_flight.counts_itself(),
                        _ => {}
                    }
                    in_flight.stage(name, record);
                }
            }
        }
    }

    /// Where in the ring of blocks a person's is, bytes.
    fn block(&self, instance: usize) -> u32 {
        self.shared.blocks.offset(self.frame, instance) as u32
    }

    /// The kernels of an avatar.
    fn kernels(&self, avatar: AvatarId) -> &AvatarKernels {
        &self.avatars.get(avatar).expect(SCHEDULED).kernels
    }

    /// The draw into a layer's image.
    fn draw(&self, target: RenderTarget) -> &Draw<'_> {
        match target {
            RenderTarget::Atlas => self.atlas.as_ref().expect(SCHEDULED),
            RenderTarget::Image => &self.image,
        }
    }

    fn record(&self, commands: Recording, command: &FrameCommand) {
        match command {
            FrameCommand::Barrier(barrier) => {
                let [from, to] = [before(barrier.before), after(barrier.after)];
                // Where nothing is left of it, render passes order it.
                if !from.stages.is_empty() && !to.stages.is_empty() {
                    commands.barrier(from, to);
                }
            }
            FrameCommand::Run(pass) => self.run(commands, pass),
        }
    }

    fn run(&self, commands: Recording, pass: &Pass) {
        let SharedStages {
            splats,
            sort,
            raster,
            control,
            ..
        } = self.shared;
        match *pass {
            Pass::SetKeyCount { keys } => {
                // SAFETY: the buffer holds a control, and is dropped after the frames in flight.
                unsafe { set_control(commands, control.raw(), keys) };
            }
            Pass::ClearCounts => {
                sort.clear(commands);
                splats.clear(commands);
            }
            Pass::Mlp {
                instance,
                avatar,
                parts,
            } => {
                let mlp = &self.kernels(avatar).mlp;
                mlp.record(commands, self.block(instance), parts);
            }
            Pass::Sh {
                instance,
                avatar,
                model,
                gaussians,
            } => {
                let sh = &self.kernels(avatar).sh;
                sh.record(commands, self.block(instance), model, gaussians);
            }
            Pass::Project {
                instance,
                avatar,
                model,
                gaussians,
                skinning,
            } => {
                let project = &self.kernels(avatar).project;
                project.record(commands, self.block(instance), model, gaussians, skinning);
            }
            Pass::Sort => sort.record_counted(commands),
            Pass::ClearTileLists => raster.clear_tile_lists(commands),
            Pass::Binning { target } => {
                raster.record_binning(commands, self.draw(target).frame);
            }
            Pass::Bin { target } => raster.record_bins(commands, self.draw(target)),
            Pass::Saturation => raster.record_saturation(commands, &self.image),
            Pass::RasterTiles { target, .. } => {
                raster.record(commands, self.draw(target), false, None);
            }
            Pass::RasterQuads { tested, target } => {
                raster.record(commands, self.draw(target), tested, self.screen);
            }
            Pass::Resolve { clear } => {
                let slots = &self.plan.atlas.as_ref().expect(SCHEDULED).slots;
                raster.record_resolve(commands, &self.image, slots, clear);
            }
            // A step of its own.
            Pass::KeepCounts => {}
            // The counts are copied where the frame is submitted.
            Pass::ReadCounts => {}
        }
    }
}
