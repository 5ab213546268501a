//! Runs a frame's schedule: records its passes, barriers and stages into a command buffer.

use super::Renderer;
use crate::vulkan::{
    commands::control::set_control, device::recording::Recording, memory::Scope, raster::draw::Draw,
};
use ash::vk::{AccessFlags, PipelineStageFlags};
use effigy_core::frame::{
    Counters, Damage, Schedule,
    passes::{Pass, PipelineStages},
    schedule::{Barrier, Step},
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

fn order(commands: Recording, barrier: Barrier) {
    commands.barrier(before(barrier.before), after(barrier.after));
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
        let Self {
            frames_in_flight,
            options,
            mlp,
            sh,
            occluder,
            project,
            sort,
            raster,
            control,
            blocks,
            model,
            ..
        } = self;
        let in_flight = &mut frames_in_flight[frame];
        let block = |instance: usize| blocks.offset(frame, instance) as u32;
        let all_blocks: Vec<u32> = plan
            .instances
            .iter()
            .map(|instance| block(instance.index))
            .collect();
        let draw = Draw {
            // An empty image has a size too: the first block's.
            frame: all_blocks.first().copied().unwrap_or(block(0)),
            occluders: &all_blocks,
            control: control.raw(),
            damage,
            count: options.count,
        };

        let draws_occluder = schedule
            .passes()
            .any(|pass| matches!(pass, Pass::Occluder { .. }));
        let stages = StageDispatches {
            has_sh: sh.is_some(),
            has_occluder: draws_occluder,
            sort: sort.dispatches(true) as u64,
            raster: raster.dispatches(),
        };
        in_flight.note(Counters {
            damaged: if plan.redraw { damage.pixels() } else { 0 },
            ..plan.counters(model.constants.gaussians, &stages)
        });

        let run = |pass: &Pass, commands: Recording| match *pass {
            Pass::SetKeyCount { keys } => {
                // SAFETY: the buffer holds a control, and is dropped after the frames in flight.
                unsafe { set_control(commands, control.raw(), keys) };
            }
            Pass::ClearCounts => {
                sort.clear(commands);
                project.clear(commands);
            }
            Pass::Mlp { instance, parts } => mlp.record(commands, block(instance), parts),
            Pass::Sh {
                instance,
                gaussians,
            } => {
                if let Some(sh) = sh.as_ref() {
                    sh.record(commands, block(instance), gaussians);
                }
            }
            Pass::Occluder { view } => {
                if let Some(occluder) = occluder.as_ref() {
                    occluder.record(commands, &all_blocks, &view);
                }
            }
            Pass::Project {
                instance,
                gaussians,
                skinning,
            } => project.record(commands, block(instance), gaussians, skinning),
            Pass::Sort => sort.record_counted(commands),
            Pass::ClearTileLists => raster.clear_tile_lists(commands),
            Pass::Binning => raster.record_binning(commands, draw.frame),
            Pass::RasterTiles => raster.record(commands, &draw),
            Pass::RasterQuads { occluders } => raster.record(
                commands,
                &Draw {
                    occluders: if occluders { draw.occluders } else { &[] },
                    ..draw
                },
            ),
            // The counts are copied where the frame is submitted.
            Pass::ReadCounts => {}
        };
        let mut steps = schedule.steps.iter();
        while let Some(step) = steps.next() {
            match step {
                Step::Skip(stage, _) => in_flight.skip(stage.name()),
                Step::Barrier(barrier) => in_flight.record(|commands| order(commands, *barrier)),
                Step::Run(pass) => in_flight.record(|commands| run(pass, commands)),
                Step::End(_) => {}
                Step::Begin(stage) => {
                    let inside: Vec<&Step> = steps
                        .by_ref()
                        .take_while(|step| !matches!(step, Step::End(_)))
                        .collect();
                    let is = |wanted: fn(&Pass) -> bool| {
                        inside.iter().filter_map(|step| step.pass()).any(wanted)
                    };
                    let record = |commands: Recording| {
                        for step in &inside {
                            match step {
                                Step::Barrier(barrier) => order(commands, *barrier),
                                Step::Run(pass) => run(pass, commands),
                                _ => {}
                            }
                        }
                    };
                    if is(|pass| matches!(pass, Pass::RasterQuads { .. })) {
                        in_flight.drawing(stage.name(), options.count, record);
                    } else {
                        if options.count && is(|pass| *pass == Pass::RasterTiles) {
                            in_flight.counts_itself();
                        }
                        in_flight.stage(stage.name(), record);
                    }
                }
            }
        }
    }
}
