//! Runs a frame's schedule: records its passes and stages into a command encoder. WebGPU orders
//! memory by itself, so barriers are passed over.

use super::{
    device::Gpu,
    frame_in_flight::{FrameInFlight, Writes},
    mlp::Mlp,
    occluder::OccluderPass,
    project::Project,
    raster::Raster,
    sh::SphericalHarmonics,
    sort::Sort,
};
use bytemuck::bytes_of;
use effigy_core::{
    frame::{
        Damage, Schedule,
        passes::Pass,
        schedule::{ScheduledStage, Step},
    },
    layout::{Control, QUADS_PER_INSTANCE},
};

/// What holds of every schedule.
const SCHEDULED: &str = "a renderer schedules only stages that it has";

/// What passes are recorded with: a renderer's stages, and where a frame's data lies.
pub struct Executor<'a> {
    pub gpu: &'a Gpu,
    pub mlp: &'a Mlp,
    pub sh: Option<&'a SphericalHarmonics>,
    pub occluder: Option<&'a OccluderPass>,
    pub project: &'a Project,
    pub sort: &'a Sort,
    pub raster: &'a Raster,
    pub control: &'a wgpu::Buffer,
    /// Where an avatar's uniform block is, bytes.
    pub block: fn(usize) -> u32,
    /// Those of the avatars in view.
    pub blocks: &'a [u32],
    /// The rectangle to draw.
    pub damage: &'a Damage,
}

/// What WebGPU runs a stage's pass in.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// The encoder itself: copies and fills.
    Encoder,
    /// A compute pass, with the passes beside it that run in one too.
    Compute,
    /// Render passes of its own, or more than one pass.
    Own,
}

fn place(pass: &Pass) -> Place {
    match pass {
        Pass::SetKeyCount { .. }
        | Pass::ClearCounts
        | Pass::ClearTileLists
        | Pass::KeepCounts
        | Pass::ReadCounts => Place::Encoder,
        Pass::Mlp { .. }
        | Pass::Sh { .. }
        | Pass::Project { .. }
        | Pass::Sort
        | Pass::Binning { .. }
        | Pass::Saturation
        | Pass::RasterTiles { .. } => Place::Compute,
        Pass::Occluder { .. }
        | Pass::Bin { .. }
        | Pass::RasterQuads { .. }
        | Pass::Resolve { .. } => Place::Own,
    }
}

impl Executor<'_> {
    /// Records a schedule, in its order. The frame in flight must have begun, and nothing of it be
    /// submitted.
    pub fn execute(
        &self,
        in_flight: &mut FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        schedule: &Schedule,
    ) {
        for step in &schedule.steps {
            match step {
                Step::Skip(stage, _) => in_flight.skip(*stage),
                Step::Command(command) => {
                    if let Some(pass) = command.pass() {
                        self.encode(encoder, pass);
                    }
                }
                Step::Stage(stage) => self.stage(in_flight, encoder, stage),
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
        let shared = |a: &&Pass, b: &&Pass| [a, b].map(|pass| place(pass)) == [Place::Compute; 2];
        let groups: Vec<&[&Pass]> = passes.chunk_by(shared).collect();
        let timed = |group: &&[&Pass]| place(group[0]) != Place::Encoder;
        let first = groups.iter().position(timed);
        let last = groups.iter().rposition(timed);
        for (at, group) in groups.into_iter().enumerate() {
            let writes = [
                begin.filter(|_| Some(at) == first),
                end.filter(|_| Some(at) == last),
            ];
            match place(group[0]) {
                Place::Encoder => self.encode(encoder, group[0]),
                Place::Own => self.own(in_flight, encoder, group[0], writes),
                Place::Compute => {
                    let mut compute = in_flight.pass(encoder, scheduled.stage, writes);
                    for pass in group {
                        self.dispatch(&mut compute, pass);
                    }
                }
            }
        }
    }

    /// The block with the image's size. An empty image has a size too: the first block's.
    fn image_block(&self) -> u32 {
        match self.blocks.first() {
            Some(block) => *block,
            None => (self.block)(0),
        }
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, pass: &Pass) {
        match *pass {
            Pass::SetKeyCount { keys } => {
                let control = Control {
                    index_count: 6 * QUADS_PER_INSTANCE,
                    key_count: keys,
                    ..Control::default()
                };
                // Before all that the encoder holds, and after the frames before.
                self.gpu
                    .queue
                    .write_buffer(self.control, 0, bytes_of(&control));
            }
            Pass::ClearCounts => self.project.clear(encoder),
            Pass::ClearTileLists => self.raster.clear_tile_lists(encoder),
            // The counts are copied where the frame is submitted.
            Pass::KeepCounts | Pass::ReadCounts => {}
            Pass::Mlp { .. }
            | Pass::Sh { .. }
            | Pass::Occluder { .. }
            | Pass::Project { .. }
            | Pass::Sort
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
        match pass {
            Pass::Occluder { .. } => {
                let occluder = self.occluder.expect(SCHEDULED);
                occluder.record(in_flight, encoder, self.blocks, writes);
            }
            Pass::Bin { .. } => {
                let block = self.image_block();
                self.raster.record_bins(in_flight, encoder, block, writes);
            }
            Pass::RasterQuads { tested, .. } => {
                let block = self.image_block();
                self.raster
                    .record_quads(in_flight, encoder, block, self.control, *tested, writes);
            }
            _ => unreachable!("{pass:?} has no passes of its own: `place` says so"),
        }
    }

    fn dispatch(&self, compute: &mut wgpu::ComputePass, pass: &Pass) {
        match *pass {
            Pass::Mlp { instance, parts } => {
                self.mlp.record(compute, (self.block)(instance), parts);
            }
            Pass::Sh {
                instance,
                gaussians,
                ..
            } => {
                let sh = self.sh.expect(SCHEDULED);
                sh.record(compute, (self.block)(instance), gaussians);
            }
            Pass::Project {
                instance,
                gaussians,
                skinning,
                ..
            } => {
                let block = (self.block)(instance);
                self.project.record(compute, block, gaussians, skinning);
            }
            Pass::Sort => self.sort.record(compute),
            Pass::Binning { .. } => self.raster.record_binning(compute, self.image_block()),
            Pass::Saturation => {
                let block = self.image_block();
                self.raster.record_saturation(compute, block, self.damage);
            }
            Pass::RasterTiles { .. } => {
                let block = self.image_block();
                self.raster.record_tiles(compute, block, self.damage);
            }
            _ => unreachable!("{pass:?} is no kernel: `place` says so"),
        }
    }
}
