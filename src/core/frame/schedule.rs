//! A frame as a list of steps, made once, executed by both backends.

use super::{
    AvatarInstance, FramePlan, RasterMethod, Skip,
    passes::{ListForm, Pass, RenderTarget, Stage},
    resource::{PipelineStages, Resource},
    state::Layer,
};

/// A barrier over all memory: what `before` names is done, and what it wrote can be seen, before
/// what `after` names begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Barrier {
    /// Stages that finish first.
    pub before: PipelineStages,
    /// Stages that wait for them.
    pub after: PipelineStages,
}

/// Quads are tested against the saturation depth where avatars have at least this many pixels a
/// Gaussian ([`Layer::pixels_a_gaussian`]). The 200K body has 1.0 at 1024 × 1024 px, where the test
/// saves 1.8 fragments for each sample and the image is 65 dB from that of all fragments
/// (docs/experiments/065, 066). Smaller avatars are mostly drawn enlarged, which is never tested,
/// and Gaussians hardly reach all four pixels of a sample.
pub const SATURATION_PIXELS: f64 = 0.75;

/// Why a stage does not run in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkipReason {
    /// Its inputs are those of the frame before.
    Unchanged,
    /// No avatar is in view.
    NothingInView,
    /// It would cost more than it saves.
    NotWorthwhile,
    /// No avatar is drawn larger than it is shown.
    NothingSmall,
}

/// A command that a backend records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameCommand {
    /// Orders memory. Backends that order it by themselves pass over it.
    Barrier(Barrier),
    /// Runs a pass.
    Run(Pass),
}

impl FrameCommand {
    /// The pass that it runs, if it runs one.
    pub fn pass(&self) -> Option<&Pass> {
        match self {
            Self::Barrier(_) => None,
            Self::Run(pass) => Some(pass),
        }
    }
}

/// A stage of a frame: what a profiler shows under one name and one time.
#[derive(Clone, Debug, PartialEq)]
pub struct ScheduledStage {
    /// Its name.
    pub stage: Stage,
    /// Its passes and the barriers between them, in order.
    pub commands: Vec<FrameCommand>,
}

impl ScheduledStage {
    /// Its passes, in order.
    pub fn passes(&self) -> impl Iterator<Item = &Pass> {
        self.commands.iter().filter_map(FrameCommand::pass)
    }

    /// Whether it draws quads.
    pub fn draws_quads(&self) -> bool {
        self.passes()
            .any(|pass| matches!(pass, Pass::RasterQuads { .. }))
    }
}

/// A step of a frame, which a backend carries out.
#[derive(Clone, Debug, PartialEq)]
pub enum ScheduleStep {
    /// Work that belongs to no stage.
    Command(FrameCommand),
    /// A stage, which gets a label and timestamps.
    Stage(ScheduledStage),
    /// A stage that the renderer has and this frame does not need.
    Skip(Stage, SkipReason),
}

/// The stages and options of a renderer, which stay the same from frame to frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Equipment {
    /// An avatar's colours change with the view.
    pub sh: bool,
    /// Avatars may be drawn larger than they are shown.
    pub supersampling: bool,
    /// How splats are rasterized.
    pub method: RasterMethod,
    /// Work that frames may skip.
    pub skip: Skip,
}

impl Equipment {
    /// Whether a renderer with it has a stage. Presenting belongs to the window.
    pub fn has(&self, stage: Stage) -> bool {
        match stage {
            Stage::Mlp | Stage::Project | Stage::Sort | Stage::Raster => true,
            Stage::Sh => self.sh,
            Stage::Binning => self.lists().is_some(),
            Stage::Saturation => self.tests_depth(),
            Stage::Resolve => self.supersampling,
            Stage::Present => false,
        }
    }

    /// Whether quads are tested against the saturation depth.
    fn tests_depth(&self) -> bool {
        self.method == RasterMethod::Quads && self.skip.contains(Skip::DEPTH)
    }

    /// The lists that it makes, if any.
    pub fn lists(&self) -> Option<ListForm> {
        match self.method {
            RasterMethod::Quads => self.tests_depth().then_some(ListForm::Bins),
            RasterMethod::SharedTiles => Some(ListForm::Bins),
            RasterMethod::CooperativeTiles => Some(ListForm::Tiles),
        }
    }

    /// The stages that a renderer with it has, in the order that a frame runs them.
    pub fn stages(&self) -> impl Iterator<Item = Stage> {
        Stage::ALL.into_iter().filter(|stage| self.has(*stage))
    }
}

/// The state that the device holds from earlier frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeviceState {
    /// Number of keys in the control, which the sort takes; None if it is not known.
    pub key_count: Option<u32>,
    /// The pass that drew the last image, if that is gone since it went to the screen at once. What
    /// the pass reads is still there.
    pub lost_image: Option<Pass>,
}

/// The steps of a frame, from its first pass to its last.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameSchedule {
    /// The steps, in order.
    pub steps: Vec<ScheduleStep>,
    /// Keys that the sort takes in this frame: [`DeviceState::key_count`] of the next.
    pub key_count: u32,
}

impl FrameSchedule {
    /// The frame: which passes run, in which order, what is skipped and why. This is the one place
    /// that says so.
    pub fn new(plan: &FramePlan, equipment: &Equipment, device_state: DeviceState) -> Self {
        let mut steps = Recorder::new(device_state.key_count);
        let posed: Vec<_> = plan
            .instances()
            .filter(|instance| !instance.networks.is_empty())
            .map(|instance| Pass::Mlp {
                instance: instance.index,
                avatar: instance.avatar,
                parts: instance.networks.end() as u32,
            })
            .collect();
        let first = plan.layers().next();
        if plan.redraw {
            steps.set_key_count(first.map_or(0, Layer::key_count));
            steps.run(Pass::ClearCounts);
        } else {
            steps.set_key_count(device_state.key_count.unwrap_or_default());
        }
        if !posed.is_empty() {
            steps.stage(Stage::Mlp, posed);
        }
        let in_image = !plan.image.instances.is_empty();
        if plan.redraw {
            if let Some(atlas) = &plan.atlas {
                steps.layer(&atlas.layer, RenderTarget::Atlas, equipment);
                if in_image {
                    steps.run(Pass::KeepCounts);
                    steps.set_key_count(plan.image.key_count());
                    steps.run(Pass::ClearCounts);
                }
            }
            if in_image {
                steps.layer(&plan.image, RenderTarget::Image, equipment);
            } else if plan.atlas.is_none() {
                // An empty image is made by the stages that make any.
                steps.raster(equipment, false, RenderTarget::Image);
            }
            if plan.atlas.is_some() {
                steps.stage(Stage::Resolve, vec![Pass::Resolve { clear: !in_image }]);
            }
        } else {
            let again: Vec<Pass> = device_state.lost_image.into_iter().collect();
            if !again.is_empty() {
                steps.stage(Stage::Raster, again);
            }
        }
        for stage in equipment.stages() {
            if steps.has(stage) {
                continue;
            }
            let reason = match stage {
                _ if !plan.redraw => SkipReason::Unchanged,
                _ if first.is_none() => SkipReason::NothingInView,
                Stage::Mlp => SkipReason::Unchanged,
                Stage::Sh => SkipReason::NothingInView,
                Stage::Resolve => SkipReason::NothingSmall,
                _ => SkipReason::NotWorthwhile,
            };
            steps.skip(stage, reason);
        }
        steps.run(Pass::ReadCounts);
        Self {
            key_count: steps.key_count.unwrap_or_default(),
            steps: steps.steps,
        }
    }

    /// The stages that this frame skips, with the reasons.
    pub fn skipped(&self) -> impl Iterator<Item = (Stage, SkipReason)> {
        self.steps.iter().filter_map(|step| match step {
            ScheduleStep::Skip(stage, reason) => Some((*stage, *reason)),
            _ => None,
        })
    }

    /// The passes, in order.
    pub fn passes(&self) -> impl Iterator<Item = &Pass> {
        self.commands().filter_map(FrameCommand::pass)
    }

    /// The pass that draws the image, if quads do: [`DeviceState::lost_image`] of the next frame if
    /// the image is not kept.
    pub fn quads(&self) -> Option<Pass> {
        let draws = |pass: &&Pass| match pass {
            Pass::RasterQuads { target, .. } => *target == RenderTarget::Image,
            _ => false,
        };
        self.passes().find(draws).copied()
    }

    /// The stages that run, in order.
    pub fn stages(&self) -> impl Iterator<Item = &ScheduledStage> {
        self.steps.iter().filter_map(|step| match step {
            ScheduleStep::Stage(stage) => Some(stage),
            _ => None,
        })
    }

    /// How often a stage runs: once for each image that is drawn.
    pub fn runs(&self, stage: Stage) -> u64 {
        let runs = self.stages().filter(|scheduled| scheduled.stage == stage);
        runs.count() as u64
    }

    /// All passes and barriers, in order, those of stages included.
    pub fn commands(&self) -> impl Iterator<Item = &FrameCommand> {
        self.steps.iter().flat_map(|step| match step {
            ScheduleStep::Command(command) => std::slice::from_ref(command),
            ScheduleStep::Stage(stage) => &stage.commands,
            ScheduleStep::Skip(..) => &[],
        })
    }
}

/// The accesses to a resource so far, while steps are put in order.
#[derive(Clone, Copy)]
struct History {
    /// Where it was written last, and where that can be seen.
    written: PipelineStages,
    visible: PipelineStages,
    /// Where it was read since, and what waits for that.
    read: PipelineStages,
    waits: PipelineStages,
}

impl Default for History {
    /// Nothing has used it since the barrier that a frame begins with.
    fn default() -> Self {
        Self {
            written: PipelineStages::empty(),
            visible: PipelineStages::all(),
            read: PipelineStages::empty(),
            waits: PipelineStages::all(),
        }
    }
}

/// Puts steps in order, with the barriers that the passes' uses of memory ask for.
struct Recorder {
    steps: Vec<ScheduleStep>,
    /// Number of keys in the control, which the sort takes; None if it is not known.
    key_count: Option<u32>,
    /// The stage that commands go into, while there is one.
    open: Option<ScheduledStage>,
    history: [History; Resource::ALL.len()],
}

impl Recorder {
    /// Begins with what the frame before may still use, anywhere. Its image is its own until the
    /// backend hands it over.
    fn new(key_count: Option<u32>) -> Self {
        Self {
            key_count,
            steps: vec![ScheduleStep::Command(FrameCommand::Barrier(Barrier {
                before: PipelineStages::all() - PipelineStages::COLOR,
                after: PipelineStages::all() - PipelineStages::COLOR,
            }))],
            open: None,
            history: [History::default(); Resource::ALL.len()],
        }
    }

    fn push(&mut self, command: FrameCommand) {
        match &mut self.open {
            Some(stage) => stage.commands.push(command),
            None => self.steps.push(ScheduleStep::Command(command)),
        }
    }

    fn run(&mut self, pass: Pass) {
        self.order(&pass);
        self.push(FrameCommand::Run(pass));
    }

    fn stage(&mut self, stage: Stage, passes: Vec<Pass>) {
        // What the first pass waits for is not the stage's time.
        if let Some(first) = passes.first() {
            self.barrier(first);
        }
        self.open = Some(ScheduledStage {
            stage,
            commands: Vec::new(),
        });
        for pass in passes {
            self.run(pass);
        }
        self.steps.extend(self.open.take().map(ScheduleStep::Stage));
    }

    /// Has the sort take that many keys.
    fn set_key_count(&mut self, keys: u32) {
        if self.key_count != Some(keys) {
            self.run(Pass::SetKeyCount { keys });
            self.key_count = Some(keys);
        }
    }

    /// Whether a stage is among the steps.
    fn has(&self, stage: Stage) -> bool {
        self.steps
            .iter()
            .any(|step| matches!(step, ScheduleStep::Stage(own) if own.stage == stage))
    }

    fn skip(&mut self, stage: Stage, reason: SkipReason) {
        self.steps.push(ScheduleStep::Skip(stage, reason));
    }

    /// Draws the avatars of a layer, at least one.
    fn layer(&mut self, layer: &Layer, target: RenderTarget, equipment: &Equipment) {
        self.geometry(layer);
        self.stage(Stage::Sort, vec![Pass::Sort]);
        let tested = target == RenderTarget::Image
            && equipment.tests_depth()
            && layer.pixels_a_gaussian >= SATURATION_PIXELS;
        self.raster(equipment, tested, target);
    }

    /// Colours and projection of all avatars of a layer.
    fn geometry(&mut self, layer: &Layer) {
        let sh = |instance: &AvatarInstance| Pass::Sh {
            instance: instance.index,
            avatar: instance.avatar,
            model: instance.model,
            gaussians: instance.gaussians,
        };
        let first = layer.instances.iter().find(|instance| instance.has_sh);
        if let Some(first) = first {
            self.stage(Stage::Sh, vec![sh(first)]);
        }
        let mut passes = Vec::new();
        for instance in &layer.instances {
            // People of one avatar share one buffer of colours: each one's replace those of the one
            // before, once these are used.
            if instance.has_sh && first.is_some_and(|first| first.index != instance.index) {
                passes.push(sh(instance));
            }
            passes.push(Pass::Project {
                instance: instance.index,
                avatar: instance.avatar,
                model: instance.model,
                gaussians: instance.gaussians,
                skinning: instance.changes.skinning,
            });
        }
        self.stage(Stage::Project, passes);
    }

    /// `tested`: whether quads are tested against the saturation depth.
    fn raster(&mut self, equipment: &Equipment, tested: bool, target: RenderTarget) {
        let lists = equipment
            .lists()
            .filter(|_| tested || equipment.method.is_tiles());
        match lists {
            Some(ListForm::Tiles) => {
                let lists = vec![Pass::ClearTileLists, Pass::Binning { target }];
                self.stage(Stage::Binning, lists);
            }
            Some(ListForm::Bins) => self.stage(Stage::Binning, vec![Pass::Bin { target }]),
            None => {}
        }
        if tested {
            self.stage(Stage::Saturation, vec![Pass::Saturation]);
        }
        let raster = match lists.filter(|_| equipment.method.is_tiles()) {
            Some(lists) => Pass::RasterTiles { lists, target },
            None => Pass::RasterQuads { tested, target },
        };
        self.stage(Stage::Raster, vec![raster]);
    }

    /// The barrier that a pass needs before it, if any: after writes of what it uses, and after
    /// reads of what it writes.
    fn barrier(&mut self, pass: &Pass) {
        let mut before = PipelineStages::empty();
        let mut after = PipelineStages::empty();
        for used in pass.uses() {
            let history = self.history[used.resource as usize];
            if !history.visible.contains(used.stages) {
                before |= history.written;
                after |= used.stages;
            }
            if used.writes && !history.waits.contains(used.stages) {
                before |= history.read;
                after |= used.stages;
            }
        }
        if before.is_empty() {
            return;
        }
        for history in &mut self.history {
            if before.contains(history.written) {
                history.visible |= after;
            }
            if before.contains(history.read) {
                history.waits |= after;
            }
        }
        self.push(FrameCommand::Barrier(Barrier { before, after }));
    }

    fn order(&mut self, pass: &Pass) {
        self.barrier(pass);
        for used in pass.uses() {
            let history = &mut self.history[used.resource as usize];
            if used.writes {
                *history = History {
                    written: used.stages,
                    visible: PipelineStages::empty(),
                    read: PipelineStages::empty(),
                    waits: PipelineStages::all(),
                };
            } else {
                history.read |= used.stages;
                history.waits = PipelineStages::empty();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        avatar::{Avatar, Pose},
        frame::{
            AvatarId, AvatarTraits, Counters, FrameState, PlanInput, RendererOptions,
            StageDispatches, capacity::Capacity, passes::Use, people::PlannedPerson,
        },
        scene::{AvatarBounds, Camera, Posed, Supersampling},
    };
    use glam::{DAffine3, DVec3};

    const SIZE: [u32; 2] = [256, 256];

    /// Plans frames of the demo with some options.
    struct Planner {
        avatar: Avatar,
        traits: AvatarTraits,
        options: RendererOptions,
        state: FrameState,
        device_state: DeviceState,
        /// Those of the last frame.
        counters: Counters,
    }

    impl Planner {
        fn new(options: RendererOptions) -> Self {
            let avatar = crate::demo::avatar().unwrap();
            Self {
                traits: AvatarTraits::new(&avatar, AvatarBounds::new(&avatar)),
                avatar,
                options: RendererOptions {
                    size: SIZE,
                    supersampling: Supersampling::OFF,
                    ..options
                },
                state: FrameState::default(),
                device_state: DeviceState::default(),
                counters: Counters::default(),
            }
        }

        fn posed(&self, bend: f64, aside: f64) -> Posed {
            let mut pose = Pose::rest(self.avatar.skeleton.len(), self.avatar.inputs.expression);
            pose.rotation[3] = DVec3::X * bend;
            Posed::new(&self.avatar, &pose).placed(DAffine3::from_translation(DVec3::X * aside))
        }

        fn camera(&self, yaw: f64) -> Camera {
            let joints = self.posed(0.0, 0.0).joints;
            let middle = self.traits.bounds.framing(&joints).middle();
            Camera::orbit(middle, yaw, 0.0, 3.0, 0.6, self.options.size)
        }

        fn frame(&mut self, poses: &[Posed], yaw: f64, equipment: &Equipment) -> FrameSchedule {
            let camera = self.camera(yaw);
            self.traits.has_sh = equipment.sh;
            let person = |posed| PlannedPerson {
                avatar: AvatarId::FIRST,
                traits: &self.traits,
                posed,
            };
            let people: Vec<_> = poses.iter().map(person).collect();
            let capacity = Capacity::new(&self.options, &self.traits.bounds);
            let plan = self.state.plan(PlanInput {
                people: &people,
                camera: &camera,
                options: &self.options,
                capacity: capacity.expect("room for all"),
                always_submit: true,
            });
            let schedule = FrameSchedule::new(&plan, equipment, self.device_state);
            let dispatches = StageDispatches { sort: 0, raster: 0 };
            self.counters = plan.counters(&dispatches);
            self.device_state.key_count = Some(schedule.key_count);
            schedule
        }
    }

    fn equipment(method: RasterMethod, sh: bool) -> Equipment {
        Equipment {
            sh,
            supersampling: false,
            method,
            skip: Skip::all() - Skip::DEPTH,
        }
    }

    /// Quads without and with the depth test, and tiles with either form of lists.
    fn every_raster() -> [Equipment; 4] {
        let quads = equipment(RasterMethod::Quads, false);
        [
            quads,
            Equipment {
                skip: Skip::all(),
                ..quads
            },
            equipment(RasterMethod::SharedTiles, false),
            equipment(RasterMethod::CooperativeTiles, false),
        ]
    }

    fn names(schedule: &FrameSchedule) -> Vec<&'static str> {
        schedule.stages().map(|stage| stage.stage.name()).collect()
    }

    /// Between a use of memory and the last write before it, and between a write and the reads
    /// since the last one, stands a barrier that names both ends.
    fn assert_ordered(schedule: &FrameSchedule) {
        let mut earlier: Vec<(usize, Pass, Use)> = Vec::new();
        let commands: Vec<&FrameCommand> = schedule.commands().collect();
        for (at, command) in commands.iter().enumerate() {
            let FrameCommand::Run(pass) = command else {
                continue;
            };
            for used in pass.uses() {
                for (before, other, former) in &earlier {
                    if former.resource != used.resource || !(former.writes || used.writes) {
                        continue;
                    }
                    let ordered = commands[*before..at].iter().any(|command| {
                        matches!(command, FrameCommand::Barrier(barrier)
                            if barrier.before.contains(former.stages)
                                && barrier.after.contains(used.stages))
                    });
                    assert!(
                        ordered,
                        "{other:?} and {pass:?} share {:?} without a barrier",
                        used.resource
                    );
                }
            }
            for used in pass.uses() {
                // What came before a write is ordered by it.
                earlier.retain(|(_, _, former)| !(used.writes && former.resource == used.resource));
                earlier.push((at, *pass, used));
            }
        }
    }

    #[test]
    fn the_first_frame_runs_every_stage() {
        let mut planner = Planner::new(RendererOptions::new(SIZE));
        let poses = [planner.posed(0.1, 0.0)];
        let tiles = equipment(RasterMethod::CooperativeTiles, true);
        let first = planner.frame(&poses, 0.0, &tiles);
        assert_eq!(
            names(&first),
            ["mlp", "sh", "project", "sort", "binning", "raster"]
        );
        assert_eq!(first.skipped().count(), 0);
        assert_ordered(&first);
    }

    #[test]
    fn a_frame_without_change_only_reads_counts() {
        let mut planner = Planner::new(RendererOptions::new(SIZE));
        let poses = [planner.posed(0.1, 0.0)];
        let quads = equipment(RasterMethod::Quads, false);
        planner.frame(&poses, 0.0, &quads);
        let second = planner.frame(&poses, 0.0, &quads);
        assert_eq!(second.passes().collect::<Vec<_>>(), [&Pass::ReadCounts]);
        let skipped: Vec<_> = second.skipped().collect();
        let stages = [Stage::Mlp, Stage::Project, Stage::Sort, Stage::Raster];
        assert_eq!(skipped, stages.map(|stage| (stage, SkipReason::Unchanged)));
    }

    /// An image that only its screen has is drawn again from what the frame before left.
    #[test]
    fn a_lost_image_is_drawn_again_as_it_was() {
        for raster in &every_raster()[..2] {
            let mut planner = Planner::new(RendererOptions::new(SIZE));
            let poses = [planner.posed(0.1, 0.0)];
            let first = planner.frame(&poses, 0.0, raster);
            planner.device_state.lost_image = first.quads();
            let second = planner.frame(&poses, 0.0, raster);
            assert_eq!(names(&second), ["raster"]);
            assert_eq!(second.quads(), first.quads());
            assert!(!second.skipped().any(|(stage, _)| stage == Stage::Raster));
            let moved = planner.frame(&poses, 0.3, raster);
            assert_eq!(moved.runs(Stage::Raster), 1);
            assert_ordered(&moved);
        }
    }

    /// A stage that a renderer has runs or is skipped, whatever it draws.
    #[test]
    fn every_stage_runs_or_is_skipped() {
        for equipment in every_raster() {
            for sh in [false, true] {
                let mut planner = Planner::new(RendererOptions::new(SIZE));
                let equipment = Equipment { sh, ..equipment };
                for aside in [0.0, 0.0, 1000.0, 1000.0, 0.0] {
                    let poses = [planner.posed(0.1, aside)];
                    let frame = planner.frame(&poses, 0.0, &equipment);
                    let mut found: Vec<Stage> = frame.stages().map(|stage| stage.stage).collect();
                    found.extend(frame.skipped().map(|(stage, _)| stage));
                    found.sort();
                    assert_eq!(found, equipment.stages().collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn a_moved_camera_skips_the_networks() {
        let mut planner = Planner::new(RendererOptions::new(SIZE));
        let poses = [planner.posed(0.1, 0.0)];
        let tiles = equipment(RasterMethod::CooperativeTiles, false);
        planner.frame(&poses, 0.0, &tiles);
        let second = planner.frame(&poses, 0.3, &tiles);
        assert_eq!(
            second.skipped().next(),
            Some((Stage::Mlp, SkipReason::Unchanged))
        );
        assert!(names(&second).contains(&"project"));
        assert_ordered(&second);
    }

    #[test]
    fn nothing_in_view_leaves_an_empty_image() {
        let mut planner = Planner::new(RendererOptions::new(SIZE));
        let far = [planner.posed(0.1, 1000.0)];
        let tiles = equipment(RasterMethod::CooperativeTiles, false);
        let frame = planner.frame(&far, 0.0, &tiles);
        let reasons: Vec<_> = frame.skipped().collect();
        let stages = [Stage::Mlp, Stage::Project, Stage::Sort];
        assert_eq!(
            reasons,
            stages.map(|stage| (stage, SkipReason::NothingInView))
        );
        assert_eq!(names(&frame), ["binning", "raster"]);
        assert_eq!(frame.key_count, 0);
    }

    #[test]
    fn barriers_order_every_kind_of_frame() {
        for raster in every_raster() {
            for sh in [false, true] {
                for skip in [Skip::all(), Skip::empty(), Skip::DEPTH] {
                    let mut planner = Planner::new(RendererOptions {
                        instances: 3,
                        skip,
                        ..RendererOptions::new(SIZE)
                    });
                    let equipment = Equipment { sh, skip, ..raster };
                    for (bend, yaw) in [(0.1, 0.0), (0.1, 0.2), (0.3, 0.2), (0.3, 0.2), (0.3, 0.4)]
                    {
                        let poses = [-1.0, 0.0, 1.0].map(|aside| planner.posed(bend, aside));
                        let frame = planner.frame(&poses, yaw, &equipment);
                        assert_ordered(&frame);
                    }
                }
            }
        }
    }

    /// The atlas comes first, then the image if it has avatars, and each of both has all stages.
    #[test]
    fn small_avatars_are_drawn_first_and_resolved_last() {
        for raster in every_raster() {
            let mut planner = Planner::new(RendererOptions {
                instances: 2,
                ..RendererOptions::new(SIZE)
            });
            planner.options.size = [1024, 1024];
            planner.options.supersampling = Supersampling::BySize;
            let equipment = Equipment {
                supersampling: true,
                ..raster
            };
            let near = planner.posed(0.1, 0.0);
            let back = planner.camera(0.0).view.matrix3.transpose().z_axis;
            let far = planner
                .posed(0.1, 0.0)
                .placed(DAffine3::from_translation(30.0 * back));
            let gone = planner.posed(0.1, 1e4);
            let sorts = |frame: &FrameSchedule| {
                let names = names(frame);
                names.iter().filter(|name| **name == "sort").count()
            };
            let resolves = |frame: &FrameSchedule| {
                frame.passes().find_map(|pass| match pass {
                    Pass::Resolve { clear } => Some(*clear),
                    _ => None,
                })
            };
            let both = planner.frame(&[near.clone(), far.clone()], 0.0, &equipment);
            assert_eq!((sorts(&both), resolves(&both)), (2, Some(false)));
            assert!(names(&both).ends_with(&["raster", "resolve"]));
            assert!(both.passes().any(|pass| *pass == Pass::KeepCounts));
            let Counters {
                atlas,
                resolved,
                averaged,
                ..
            } = planner.counters;
            assert!(0 < resolved && resolved < averaged && averaged <= atlas + resolved);
            let small = planner.frame(&[gone.clone(), far], 0.0, &equipment);
            assert_eq!((sorts(&small), resolves(&small)), (1, Some(true)));
            let large = planner.frame(&[near, gone.clone()], 0.0, &equipment);
            assert_eq!((sorts(&large), resolves(&large)), (1, None));
            assert_eq!([planner.counters.atlas, planner.counters.resolved], [0; 2]);
            let none = planner.frame(&[gone.clone(), gone], 0.0, &equipment);
            assert_eq!((sorts(&none), resolves(&none)), (0, None));
            for frame in [both, small, large, none] {
                assert_ordered(&frame);
            }
        }
    }

    /// Only an avatar in view is worth it, and only one whose Gaussians are large in the image.
    #[test]
    fn quads_are_tested_where_it_is_worthwhile() {
        let [_, tested, ..] = every_raster();
        let frame = |size, aside| {
            let mut planner = Planner::new(RendererOptions::new(SIZE));
            planner.options.size = size;
            let poses = [planner.posed(0.1, aside)];
            planner.frame(&poses, 0.0, &tested)
        };
        let tests = |frame: &FrameSchedule| {
            frame
                .passes()
                .any(|pass| matches!(pass, Pass::RasterQuads { tested: true, .. }))
        };
        let large = frame([2048, 2048], 0.0);
        let last = ["sort", "binning", "saturation", "raster"];
        assert!(names(&large).ends_with(&last), "{:?}", names(&large));
        assert!(tests(&large));
        let small = frame([128, 128], 0.0);
        assert!(names(&small).ends_with(&["sort", "raster"]) && !tests(&small));
        let reason = (Stage::Saturation, SkipReason::NotWorthwhile);
        assert!(small.skipped().any(|skipped| skipped == reason));
        let away = frame([2048, 2048], 1000.0);
        assert!(names(&away) == ["raster"] && !tests(&away));
    }

    /// What is counted as one avatar's work runs for each, anything else once.
    #[test]
    fn stages_run_once_or_for_each_avatar() {
        for raster in every_raster() {
            let mut planner = Planner::new(RendererOptions {
                instances: 2,
                ..RendererOptions::new([2048, 2048])
            });
            planner.options.size = [2048, 2048];
            let poses = [-0.5, 0.5].map(|aside| planner.posed(0.1, aside));
            let frame = planner.frame(&poses, 0.0, &Equipment { sh: true, ..raster });
            assert_eq!(frame.skipped().count(), 0);
            for stage in frame.stages().map(|stage| stage.stage) {
                let runs = |pass: &&Pass| {
                    pass.stage() == Some(stage) && !matches!(pass, Pass::ClearTileLists)
                };
                let expected = if stage.is_per_avatar() { 2 } else { 1 };
                assert_eq!(frame.passes().filter(runs).count(), expected, "{stage:?}");
            }
        }
    }

    #[test]
    fn instances_take_turns_at_the_colours() {
        let mut planner = Planner::new(RendererOptions {
            instances: 2,
            ..RendererOptions::new(SIZE)
        });
        let poses = [-0.5, 0.5].map(|aside| planner.posed(0.1, aside));
        let frame = planner.frame(
            &poses,
            0.0,
            &equipment(RasterMethod::CooperativeTiles, true),
        );
        let order: Vec<_> = frame
            .passes()
            .filter_map(|pass| match pass {
                Pass::Sh { instance, .. } => Some(("sh", *instance)),
                Pass::Project { instance, .. } => Some(("project", *instance)),
                _ => None,
            })
            .collect();
        assert_eq!(
            order,
            [("sh", 0), ("project", 0), ("sh", 1), ("project", 1)]
        );
    }
}
