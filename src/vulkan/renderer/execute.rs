//! Runs a frame's schedule: records its passes, barriers and stages into a command buffer.

use super::Renderer;
use super::blocks::Blocks;
use crate::vulkan::{
    commands::control::set_control,
    device::recording::Recording,
    memory::Scope,
    passes::{mlp::Mlp, occluder::OccluderPass, project::Project, sh::SphericalHarmonics},
    raster::{Raster, draw::Draw},
    sort::Sort,
};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use effigy_core::frame::{
    Counters, Damage, RasterMethod, Schedule,
    passes::{Pass, PipelineStages},
    schedule::{Command, Step},
    state::{FramePlan, StageDispatches},
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
    vertex: AccessFlags,
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
        vertex,
    );
    let arguments = if vertex.is_empty() {
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

/// What passes are recorded with: a renderer's stages, and where a frame's data lies.
struct Executor<'a> {
    mlp: &'a Mlp,
    sh: Option<&'a SphericalHarmonics>,
    occluder: Option<&'a OccluderPass>,
    project: &'a Project,
    sort: &'a Sort,
    raster: &'a Raster,
    control: vk::Buffer,
    blocks: &'a Blocks,
    /// Index of the frame in flight.
    frame: usize,
    draw: Draw<'a>,
}

impl Executor<'_> {
    /// Where in the ring of blocks an avatar's is, bytes.
    fn block(&self, instance: usize) -> u32 {
        self.blocks.offset(self.frame, instance) as u32
    }

    fn record(&self, commands: Recording, command: &Command) {
        match command {
            Command::Barrier(barrier) => {
                commands.barrier(before(barrier.before), after(barrier.after));
            }
            Command::Run(pass) => self.run(commands, pass),
        }
    }

    fn run(&self, commands: Recording, pass: &Pass) {
        match *pass {
            Pass::SetKeyCount { keys } => {
                // SAFETY: the buffer holds a control, and is dropped after the frames in flight.
                unsafe { set_control(commands, self.control, keys) };
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
                gaussians,
            } => {
                if let Some(sh) = self.sh {
                    sh.record(commands, self.block(instance), gaussians);
                }
            }
            Pass::Occluder { view } => {
                if let Some(occluder) = self.occluder {
                    occluder.record(commands, self.draw.occluders, &view);
                }
            }
            Pass::Project {
                instance,
                gaussians,
                skinning,
            } => {
                let block = self.block(instance);
                self.project.record(commands, block, gaussians, skinning);
            }
            Pass::Sort => self.sort.record_counted(commands),
            Pass::ClearTileLists => self.raster.clear_tile_lists(commands),
            Pass::Binning => self.raster.record_binning(commands, self.draw.frame),
            Pass::RasterTiles | Pass::RasterQuads { occluders: true } => {
                self.raster.record(commands, &self.draw);
            }
            Pass::RasterQuads { occluders: false } => {
                let draw = Draw {
                    occluders: &[],
                    ..self.draw
                };
                self.raster.record(commands, &draw);
            }
            // The counts are copied where the frame is submitted.
            Pass::ReadCounts => {}
        }
    }
}

impl Renderer {
    /// Records a schedule. The frame in flight must be recording.
    pub(super) fn execute(
        &mut self,
        frame: usize,
        schedule: &Schedule,
        plan: &FramePlan,
        damage: &Damage,
    ) {
        let stages = StageDispatches {
            has_sh: self.sh.is_some(),
            has_occluder: schedule
                .passes()
                .any(|pass| matches!(pass, Pass::Occluder { .. })),
            sort: self.sort.dispatches(true) as u64,
            raster: self.raster.dispatches(),
        };
        let counters = Counters {
            damaged: if plan.redraw { damage.pixels() } else { 0 },
            ..plan.counters(self.model.constants.gaussians, &stages)
        };
        let blocks: Vec<u32> = plan
            .instances
            .iter()
            .map(|instance| self.blocks.offset(frame, instance.index) as u32)
            .collect();
        let executor = Executor {
            mlp: &self.mlp,
            sh: self.sh.as_ref(),
            occluder: self.occluder.as_ref(),
            project: &self.project,
            sort: &self.sort,
            raster: &self.raster,
            control: self.control.raw(),
            blocks: &self.blocks,
            frame,
            draw: Draw {
                // An empty image has a size too: the first block's.
                frame: match blocks.first() {
                    Some(block) => *block,
                    None => self.blocks.offset(frame, 0) as u32,
                },
                occluders: &blocks,
                control: self.control.raw(),
                damage,
                count: self.options.count,
            },
        };

        let in_flight = &mut self.frames_in_flight[frame];
        in_flight.note(counters);
        for step in &schedule.steps {
            match step {
                Step::Skip(stage, _) => in_flight.skip(stage.name()),
                Step::Command(command) => {
                    in_flight.record(|commands| executor.record(commands, command));
                }
                Step::Stage(stage) => {
                    let name = stage.stage.name();
                    let record = |commands: Recording| {
                        for command in &stage.commands {
                            executor.record(commands, command);
                        }
                    };
                    match stage.raster_method() {
                        Some(RasterMethod::Quads) => {
                            in_flight.drawing(name, self.options.count, record);
                        }
                        Some(RasterMethod::Tiles) if self.options.count => {
                            in_flight.counts_itself();
                            in_flight.stage(name, record);
                        }
                        _ => in_flight.stage(name, record),
                    }
                }
            }
        }
    }
}
