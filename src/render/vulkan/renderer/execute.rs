//! Runs a frame's schedule: records its passes, barriers and stages into a command buffer.

use super::blocks::BlockRing;
use crate::vulkan::{
    commands::{
        control::set_control,
        frame_in_flight::{CountSources, FrameInFlight},
    },
    device::recording::Recording,
    memory::{Buffer, Scope},
    passes::{mlp::Mlp, project::Project, sh::SphericalHarmonics},
    raster::{Raster, draw::Draw, quad_pass::OnePassTarget},
    sort::Sort,
};
use ash::vk::{AccessFlags, PipelineStageFlags};
use effigy_core::frame::{
    FramePlan, FrameSchedule,
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
    pub mlp: &'a Mlp,
    /// Of the avatar, then of its levels; none where colours don't depend on the view.
    pub sh: &'a [SphericalHarmonics],
    pub project: &'a Project,
    pub sort: &'a Sort,
    pub raster: &'a Raster,
    pub control: &'a Buffer,
    pub counts: CountSources,
    pub blocks: &'a BlockRing,
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
                    unsafe { in_flight.keep_counts(self.counts) };
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

    /// Where in the ring of blocks an avatar's is, bytes.
    fn block(&self, instance: usize) -> u32 {
        self.blocks.offset(self.frame, instance) as u32
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
        match *pass {
            Pass::SetKeyCount { keys } => {
                // SAFETY: the buffer holds a control, and is dropped after the frames in flight.
                unsafe { set_control(commands, self.control.raw(), keys) };
            }
            Pass::ClearCounts => {
                self.sort.clear(commands);
                self.project.clear(commands);
            }
            Pass::Mlp { instance, parts } => {
                self.mlp.record(commands, self.block(instance), parts);
            }
            Pass::Sh {
                instance,
                model,
                gaussians,
            } => {
                let sh = self.sh.get(model).expect(SCHEDULED);
                sh.record(commands, self.block(instance), gaussians);
            }
            Pass::Project {
                instance,
                model,
                gaussians,
                skinning,
            } => {
                let block = self.block(instance);
                self.project
                    .record(commands, block, model, gaussians, skinning);
            }
            Pass::Sort => self.sort.record_counted(commands),
            Pass::ClearTileLists => self.raster.clear_tile_lists(commands),
            Pass::Binning { target } => {
                self.raster
                    .record_binning(commands, self.draw(target).frame);
            }
            Pass::Bin { target } => self.raster.record_bins(commands, self.draw(target)),
            Pass::Saturation => self.raster.record_saturation(commands, &self.image),
            Pass::RasterTiles { target, .. } => {
                self.raster.record(commands, self.draw(target), false, None);
            }
            Pass::RasterQuads { tested, target } => {
                self.raster
                    .record(commands, self.draw(target), tested, self.screen);
            }
            Pass::Resolve { clear } => {
                let slots = &self.plan.atlas.as_ref().expect(SCHEDULED).slots;
                self.raster
                    .record_resolve(commands, &self.image, slots, clear);
            }
            // A step of its own.
            Pass::KeepCounts => {}
            // The counts are copied where the frame is submitted.
            Pass::ReadCounts => {}
        }
    }
}
