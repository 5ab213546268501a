//! Plans a frame before anything is asked of the device: which avatars are in view, what each of
//! them has to compute again, and what they share.

use super::{
    AvatarChanges, AvatarId, ChangeTracker, Counters, RendererOptions, Skinning, Skip,
    atlas::{Arrangement, AtlasSlot, AvatarFootprint, LevelInput, arrange},
    capacity::{Capacity, Portion, PosePlaces},
    changes::AvatarView,
    damage::{Damage, regions_around},
    people::PlannedPerson,
};
use crate::avatar::{Level, LowPass};
use crate::scene::{Camera, PartSet, PixelRect, Posed, Visible, supersampling::low_pass};

/// An avatar in view.
pub struct AvatarInstance<'a> {
    /// Index among [`PlanInput::people`], by which the renderer finds its buffers.
    pub index: usize,
    /// Whose looks it has.
    pub avatar: AvatarId,
    /// Whether its colours come from spherical harmonics.
    pub has_sh: bool,
    /// Gaussians that it has, of which [`Self::gaussians`] are drawn.
    pub all_gaussians: u32,
    /// Its evaluated pose.
    pub posed: &'a Posed,
    /// The camera that sees it in the image that its layer is drawn into.
    pub camera: Camera,
    /// The part of the atlas that it must stay in; None for an avatar in the image.
    pub slot: Option<PixelRect>,
    /// Samples a pixel of the frame's image along each axis, at least 1.
    pub samples: f64,
    /// The low-pass that it is drawn with.
    pub low_pass: LowPass,
    /// Longest side of its box in the frame's image, px; infinite if it crosses the near plane, 0
    /// without supersampling.
    pub side: f64,
    /// Which of the avatar's levels is drawn ([`crate::scene::levels`]); 0 is the avatar itself.
    pub model: usize,
    /// Whether networks move it.
    pub correctives: bool,
    /// Level of detail ([`crate::scene::detail`]).
    pub level: u32,
    /// Gaussians that are drawn.
    pub gaussians: u32,
    /// Where its splats and keys start among those of its layer's avatars.
    pub first_key: u32,
    /// Where its pose cache starts among those of all avatars, Gaussians.
    pub cache_start: u32,
    /// Its place in the pose buffer, if networks move it.
    pub pose_place: usize,
    /// Which stages it needs.
    pub changes: AvatarChanges,
    /// Nearest and furthest depth along the camera's axis, metres.
    depth: [f64; 2],
    /// Area of its box in the frame's image, px²; None if it crosses the near plane.
    pixels: Option<f64>,
    /// Parts that may be in view; None without [`Skip::PARTS`].
    visible_parts: Option<PartSet>,
    /// Parts that are entirely outside the view.
    pub culled_parts: PartSet,
    /// Parts whose networks run.
    pub networks: PartSet,
}

impl AvatarInstance<'_> {
    /// Where the next avatar's splats and keys start.
    fn end_key(&self) -> u32 {
        self.first_key + self.gaussians
    }
}

/// Avatars that are drawn into one image, sorted together.
pub struct Layer<'a> {
    /// The avatars in view.
    pub instances: Vec<AvatarInstance<'a>>,
    /// Width and height of the image, px.
    pub size: [u32; 2],
    /// The regions of the image in which splats are drawn: those around [`FramePlan::drawn_rect`],
    /// all of an atlas.
    pub drawn: PixelRect,
    /// Nearest and furthest expected depth along the camera's axis, metres.
    pub depth_range: [f64; 2],
    /// Pixels of the box around an avatar for each Gaussian drawn of it, for the avatar in view
    /// with the fewest. Infinite if this decides nothing.
    pub pixels_a_gaussian: f64,
}

impl<'a> Layer<'a> {
    /// A layer for which [`Self::pixels_a_gaussian`] decides nothing.
    fn new(
        instances: Vec<AvatarInstance<'a>>,
        camera: &Camera,
        size: [u32; 2],
        drawn: PixelRect,
    ) -> Self {
        Self {
            depth_range: depth_range(&instances, camera),
            pixels_a_gaussian: f64::INFINITY,
            instances,
            size,
            drawn,
        }
    }

    /// Keys of all its avatars.
    pub fn key_count(&self) -> u32 {
        self.instances.last().map_or(0, AvatarInstance::end_key)
    }
}

/// Avatars that are drawn larger than they are shown.
pub struct Atlas<'a> {
    /// The avatars, and the image that they are drawn into.
    pub layer: Layer<'a>,
    /// The parts of the frame's image that it holds, in the order in which they are blended.
    pub slots: Vec<AtlasSlot>,
}

/// The plan of one frame.
pub struct FramePlan<'a> {
    /// The avatars drawn as large as they are shown.
    pub image: Layer<'a>,
    /// The avatars drawn larger than they are shown; None if there are no such avatars.
    pub atlas: Option<Atlas<'a>>,
    /// Whether project, sort and raster run: something in the image has changed.
    pub redraw: bool,
    /// People in the scene, in view or not.
    pub people: usize,
    /// Gaussians of all of them.
    pub gaussians: u64,
    /// A rectangle of the image around all that is drawn; the whole image without
    /// [`Skip::DAMAGE`]. Splats that correctives move further than [`AvatarBounds::visible`] allows
    /// for are cut off there, in every frame alike; by tiles at the regions around it.
    pub drawn_rect: PixelRect,
}

/// Everything that the plan of the next frame depends on.
#[derive(Clone, Copy)]
pub struct PlanInput<'a, 'pose> {
    /// Everybody, at most [`RendererOptions::instances`].
    pub people: &'a [PlannedPerson<'a, 'pose>],
    /// The camera of the frame.
    pub camera: &'a Camera,
    /// The renderer's options.
    pub options: &'a RendererOptions,
    /// How much the renderer's buffers can hold.
    pub capacity: Capacity,
    /// Whether the frame is submitted even if nothing has changed.
    pub always_submit: bool,
}

/// The compute dispatches of a frame that are not for each avatar.
#[derive(Clone, Copy, Debug)]
pub struct StageDispatches {
    /// Dispatches of the sorts.
    pub sort: u64,
    /// Dispatches of the rasterizer.
    pub raster: u64,
}

/// The state that the last frame left. A renderer keeps one and asks it for the plan of each frame.
#[derive(Clone, Default)]
pub struct FrameState {
    /// One a person, in their order.
    trackers: Vec<PersonTracker>,
    pose_places: PosePlaces,
    /// Indices of the people that the last frame drew; None before the first.
    last_drawn: Option<Vec<usize>>,
}

/// Remembers a person of the last frame.
#[derive(Clone, Default)]
struct PersonTracker {
    /// Whose looks; None before the first frame.
    avatar: Option<AvatarId>,
    changes: ChangeTracker,
}

/// An avatar in view, before it is known which image it is drawn into.
struct VisibleAvatar {
    /// Index among the people.
    index: usize,
    /// Where it is.
    visible: Visible,
    /// How it may be drawn; None without supersampling.
    footprint: Option<AvatarFootprint>,
    /// The coarsest of its levels by which nothing is lost.
    near: usize,
}

/// Where an avatar in view is drawn, and where its data goes.
struct Placement<'a> {
    /// Its slot of the atlas; None in the image.
    slot: Option<&'a AtlasSlot>,
    /// [`AvatarInstance::camera`].
    camera: Camera,
    /// [`AvatarInstance::first_key`].
    first_key: u32,
    /// [`AvatarInstance::cache_start`].
    cache_start: u32,
}

/// The avatars in view, by the image that they are drawn into.
#[derive(Default)]
struct PlacedAvatars<'a> {
    image: Vec<AvatarInstance<'a>>,
    atlas: Vec<AvatarInstance<'a>>,
}

impl<'a> PlacedAvatars<'a> {
    fn all(&self) -> impl Iterator<Item = &AvatarInstance<'a>> {
        self.image.iter().chain(&self.atlas)
    }

    fn all_mut(&mut self) -> impl Iterator<Item = &mut AvatarInstance<'a>> {
        self.image.iter_mut().chain(&mut self.atlas)
    }
}

impl FrameState {
    /// Plans the next frame and remembers it as drawn. Callers that fail to draw it must restore
    /// or reset this state, so that the next frame does not rely on it.
    pub fn plan<'pose>(&mut self, input: PlanInput<'_, 'pose>) -> FramePlan<'pose> {
        let PlanInput {
            camera, options, ..
        } = input;
        self.trackers
            .resize(options.instances, PersonTracker::default());
        for (tracker, person) in self.trackers.iter_mut().zip(input.people) {
            if tracker.avatar != Some(person.avatar) {
                *tracker = PersonTracker {
                    avatar: Some(person.avatar),
                    changes: ChangeTracker::default(),
                };
            }
        }
        let mut avatars = self.visible_avatars(&input);
        let drawn_rect = drawn_rect(&input, &avatars);
        let arrangement = arrangement(&input, &avatars);
        let portions = self.portions(&input, &mut avatars, &arrangement);
        let mut placed = self.place(&input, avatars, &portions, &arrangement);
        let redraw = self.update_view(&placed, options.skip);
        // A frame that is not submitted runs no networks: they stay due.
        if redraw || input.always_submit {
            self.schedule_networks(&input, &mut placed, redraw);
        }
        let drawn = regions_around(drawn_rect, camera.size);
        let mut image = Layer::new(placed.image, camera, camera.size, drawn);
        if redraw && options.skip.contains(Skip::DEPTH) {
            image.pixels_a_gaussian = pixels_a_gaussian(&image.instances);
        }
        let size = arrangement.size;
        let atlas = (!placed.atlas.is_empty()).then(|| Atlas {
            layer: Layer::new(placed.atlas, camera, size, PixelRect::whole(size)),
            slots: arrangement.slots,
        });
        FramePlan {
            image,
            atlas,
            redraw,
            people: input.people.len(),
            gaussians: input
                .people
                .iter()
                .map(|person| person.traits.bounds.gaussians() as u64)
                .sum(),
            drawn_rect,
        }
    }

    /// The avatars in view: all of them without [`Skip::AVATARS`].
    fn visible_avatars(&self, input: &PlanInput) -> Vec<VisibleAvatar> {
        let PlanInput {
            people,
            camera,
            options,
            ..
        } = input;
        let skip_outside = options.skip.contains(Skip::AVATARS);
        let mut avatars = Vec::with_capacity(people.len());
        for (index, PlannedPerson { traits, posed, .. }) in people.iter().enumerate() {
            let bounds = &traits.bounds;
            if skip_outside && bounds.is_outside(&posed.joints, camera) {
                continue;
            }
            let visible = bounds.visible(&posed.joints, camera);
            if skip_outside && visible.parts.is_empty() {
                continue;
            }
            let footprint = options.supersampling.is_on().then(|| {
                let level_input = LevelInput {
                    supersampling: options.supersampling,
                    before: self.trackers[index].changes.near(),
                    coarser: options.detail.coarser,
                };
                AvatarFootprint::new(bounds, &visible, level_input)
            });
            avatars.push(VisibleAvatar {
                index,
                visible,
                footprint,
                near: 0,
            });
        }
        avatars
    }

    /// The portion of each avatar in view that is drawn, within the capacity.
    fn portions(
        &self,
        input: &PlanInput,
        avatars: &mut [VisibleAvatar],
        arrangement: &Arrangement,
    ) -> Vec<Portion> {
        let mut portions: Vec<Portion> = avatars
            .iter_mut()
            .enumerate()
            .map(|(number, avatar)| self.portion(input, avatar, arrangement.slot(number)))
            .collect();
        let side = |number: usize| avatars[number].visible.longest_side();
        let bounds: Vec<_> = avatars
            .iter()
            .map(|avatar| &input.people[avatar.index].traits.bounds)
            .collect();
        input.capacity.fit(&mut portions, side, &bounds);
        portions
    }

    /// The portion of an avatar in view that is drawn if the capacity suffices. Notes which level
    /// was near enough.
    fn portion(
        &self,
        input: &PlanInput,
        avatar: &mut VisibleAvatar,
        slot: Option<&AtlasSlot>,
    ) -> Portion {
        let PlanInput {
            people, options, ..
        } = input;
        let bounds = &people[avatar.index].traits.bounds;
        let tracker = &self.trackers[avatar.index].changes;
        // Levels are for what is small, at several samples a pixel.
        if let (Some(slot), Some(footprint)) = (slot, avatar.footprint) {
            let chosen = footprint.chosen_for(bounds, slot.factor);
            avatar.near = chosen.near;
            if chosen.level > 0 {
                return Portion {
                    model: chosen.level,
                    level: 0,
                };
            }
        }
        let samples = slot.map_or(1.0, |slot| slot.factor * slot.factor);
        let pixels = || Some(samples * avatar.visible.pixels()?);
        let before = tracker.level();
        // Without levels in the file, each coarser one is half of the Gaussians.
        let coarser = slot.map_or(0, |_| options.detail.coarser as u32);
        let detail = options.detail.at_least(coarser);
        Portion {
            model: 0,
            level: detail.level(bounds.gaussians(), before, pixels),
        }
    }

    /// Places avatars in the image or in the atlas, one after the other in the buffers.
    fn place<'pose>(
        &mut self,
        input: &PlanInput<'_, 'pose>,
        avatars: Vec<VisibleAvatar>,
        portions: &[Portion],
        arrangement: &Arrangement,
    ) -> PlacedAvatars<'pose> {
        let mut placed = PlacedAvatars::default();
        let mut cache_start = 0;
        for (number, (avatar, &portion)) in avatars.into_iter().zip(portions).enumerate() {
            let slot = arrangement.slot(number);
            let instances = match slot {
                Some(_) => &mut placed.atlas,
                None => &mut placed.image,
            };
            let camera = slot.map_or(*input.camera, |slot| {
                slot.camera(input.camera, arrangement.size)
            });
            let placement = Placement {
                slot,
                camera,
                first_key: instances.last().map_or(0, AvatarInstance::end_key),
                cache_start,
            };
            let instance = self.instance(input, avatar, portion, placement);
            cache_start += instance.gaussians;
            instances.push(instance);
        }
        placed
    }

    /// An avatar in view, whose networks are still to be scheduled.
    fn instance<'pose>(
        &mut self,
        input: &PlanInput<'_, 'pose>,
        avatar: VisibleAvatar,
        portion: Portion,
        placement: Placement,
    ) -> AvatarInstance<'pose> {
        let options = input.options;
        let VisibleAvatar {
            index,
            visible,
            footprint,
            near,
        } = avatar;
        let Placement {
            slot,
            camera,
            first_key,
            cache_start,
        } = placement;
        let Portion { model, level } = portion;
        let PlannedPerson {
            avatar,
            traits,
            posed,
        } = input.people[index];
        let bounds = &traits.bounds;
        let mut skip = options.skip;
        if traits.has_sh {
            // Colours that change with the view can't come from a pose cache.
            skip -= Skip::SKINNING;
        }
        let visible_parts = options.skip.contains(Skip::PARTS).then_some(visible.parts);
        let samples = slot.map_or(1.0, |slot| slot.factor);
        let view = AvatarView {
            camera,
            portion,
            near,
            slot: slot.copied(),
            cache_start,
        };
        let changes = self.trackers[index].changes.update(posed, &view, skip);
        // The pose cache needs all parts: other cameras will see them.
        let culled_parts = match visible_parts {
            Some(visible) if changes.skinning != Skinning::ComputeAndStore => {
                traits.dependencies.all() - visible
            }
            _ => PartSet::EMPTY,
        };
        let own_filter = if model > 0 {
            Level::FILTER
        } else {
            bounds.filter()
        };
        AvatarInstance {
            index,
            avatar,
            has_sh: traits.has_sh,
            all_gaussians: bounds.gaussians() as u32,
            posed,
            camera,
            slot: slot.map(AtlasSlot::rect),
            samples,
            low_pass: low_pass(own_filter, options.filter, samples),
            side: footprint.map_or(0.0, |footprint| footprint.side),
            model,
            correctives: portion.correctives(bounds),
            level,
            gaussians: portion.gaussians(bounds),
            first_key,
            cache_start,
            pose_place: 0,
            changes,
            depth: visible.depth,
            pixels: visible.pixels(),
            visible_parts,
            culled_parts,
            networks: PartSet::EMPTY,
        }
    }

    /// Whether the image has to be drawn again. Remembers which avatars are in view.
    fn update_view(&mut self, placed: &PlacedAvatars, skip: Skip) -> bool {
        let mut in_view: Vec<_> = placed.all().map(|own| own.index).collect();
        in_view.sort_unstable();
        let redraw = !skip.contains(Skip::FRAME)
            || self.last_drawn.as_ref() != Some(&in_view)
            || placed.all().any(|own| own.changes.redraw);
        if redraw {
            for (index, tracker) in self.trackers.iter_mut().enumerate() {
                if in_view.binary_search(&index).is_err() {
                    tracker.changes.mark_absent();
                }
            }
        }
        self.last_drawn = Some(in_view);
        redraw
    }

    /// Decides which networks of a frame that is submitted run. `redraw`: whether it also draws.
    fn schedule_networks(&mut self, input: &PlanInput, placed: &mut PlacedAvatars, redraw: bool) {
        self.place_poses(placed, input.capacity.posed);
        for instance in placed.all_mut() {
            let tracker = &mut self.trackers[instance.index].changes;
            instance.networks = tracker.schedule_networks(
                &instance.changes,
                &input.people[instance.index].traits.dependencies,
                instance.visible_parts.as_ref(),
                instance.correctives,
            );
            if redraw {
                tracker.mark_drawn(&instance.changes, instance.cache_start);
            }
        }
    }

    /// Gives avatars that networks move their places, of `count`, in the pose buffer. All networks
    /// of an avatar with a new place are due.
    fn place_poses(&mut self, placed: &mut PlacedAvatars, count: usize) {
        let mut posed: Vec<_> = placed.all_mut().filter(|own| own.correctives).collect();
        posed.sort_unstable_by_key(|own| own.index);
        let indices: Vec<usize> = posed.iter().map(|own| own.index).collect();
        let places = self.pose_places.assign(&indices, count);
        for (instance, place) in posed.into_iter().zip(places) {
            instance.pose_place = place.number;
            if place.is_new {
                self.trackers[instance.index].changes.lose_networks();
            }
        }
    }
}

impl Atlas<'_> {
    /// All of it: nothing of the frame before is kept.
    pub fn damage(&self) -> Damage {
        let size = self.layer.size;
        Damage::new(PixelRect::whole(size), None, size)
    }
}

impl<'a> FramePlan<'a> {
    /// The layers that have avatars, in the order in which they are drawn.
    pub fn layers(&self) -> impl Iterator<Item = &Layer<'a>> {
        let atlas = self.atlas.as_ref().map(|atlas| &atlas.layer);
        let image = (!self.image.instances.is_empty()).then_some(&self.image);
        atlas.into_iter().chain(image)
    }

    /// All avatars in view.
    pub fn instances(&self) -> impl Iterator<Item = &AvatarInstance<'a>> {
        self.layers().flat_map(|layer| &layer.instances)
    }

    /// Whether the frame fills the pose cache of an avatar.
    pub fn stores_poses(&self) -> bool {
        let mut instances = self.instances();
        self.redraw
            && instances.any(|instance| instance.changes.skinning == Skinning::ComputeAndStore)
    }

    /// The counts that are known before the frame is drawn.
    pub fn counters(&self, stages: &StageDispatches) -> Counters {
        let avatars = self.people as u64;
        let drawn = self.instances().count() as u64;
        let mut counters = Counters {
            avatars,
            avatars_culled: avatars - drawn,
            gaussians: self.gaussians,
            submitted: 1,
            ..Counters::default()
        };
        for instance in self.instances() {
            counters.skipped_by_detail += u64::from(instance.all_gaussians - instance.gaussians);
            counters.supersampled += u64::from(instance.slot.is_some());
            counters.longest_side = counters.longest_side.max(instance.side.ceil() as u64);
            counters.most_samples = counters.most_samples.max(instance.samples.ceil() as u64);
            counters.coarsest_level = counters.coarsest_level.max(instance.model as u64);
            counters.networks += instance.networks.len() as u64;
            counters.parts_outside += instance.culled_parts.len() as u64;
            if self.redraw && instance.changes.skinning == Skinning::Cached {
                counters.cached += u64::from(instance.gaussians);
            }
            if !instance.networks.is_empty() {
                counters.dispatches += 1;
            }
        }
        if self.redraw {
            // Project, and sh where colours depend on the view, run once a person.
            let with_sh = self.instances().filter(|instance| instance.has_sh).count();
            counters.dispatches += drawn + with_sh as u64;
            counters.dispatches += stages.sort + stages.raster;
            if let Some(atlas) = &self.atlas {
                counters.atlas = PixelRect::whole(atlas.layer.size).pixels();
                for slot in &atlas.slots {
                    let shown = slot.shown(self.image.size).pixels();
                    counters.resolved += shown;
                    counters.averaged += (slot.factor.powi(2) * shown as f64).round() as u64;
                }
            }
        }
        counters
    }
}

/// [`FramePlan::drawn_rect`].
fn drawn_rect(input: &PlanInput, avatars: &[VisibleAvatar]) -> PixelRect {
    let whole = PixelRect::whole(input.camera.size);
    if !input.options.skip.contains(Skip::DAMAGE) {
        return whole;
    }
    let around = |avatar: &VisibleAvatar| {
        let person = &input.people[avatar.index];
        let has_margin = person.traits.bounds.has_margin_for(&person.posed.input);
        if has_margin {
            avatar.visible.rect
        } else {
            whole
        }
    };
    avatars
        .iter()
        .map(around)
        .fold(PixelRect::EMPTY, PixelRect::union)
}

/// Which avatars are drawn into the atlas, and where.
fn arrangement(input: &PlanInput, avatars: &[VisibleAvatar]) -> Arrangement {
    if !input.options.supersampling.is_on() {
        return Arrangement::without_slots(avatars.len());
    }
    // With supersampling, each avatar has a footprint.
    let footprints: Vec<_> = avatars.iter().filter_map(|own| own.footprint).collect();
    arrange(&footprints, input.camera.size)
}

/// [`Layer::pixels_a_gaussian`]; infinite if all avatars in view cross the near plane.
fn pixels_a_gaussian(instances: &[AvatarInstance]) -> f64 {
    instances
        .iter()
        .filter_map(|instance| Some(instance.pixels? / f64::from(instance.gaussians.max(1))))
        .fold(f64::INFINITY, f64::min)
}

/// A range of depths around all avatars in view, metres; an arbitrary valid range without avatars.
fn depth_range(instances: &[AvatarInstance], camera: &Camera) -> [f64; 2] {
    instances
        .iter()
        .map(|instance| instance.depth)
        .reduce(|[low, high], [near, far]| [low.min(near), high.max(far)])
        .unwrap_or([camera.near, 2.0 * camera.near])
}
