//! Plans a frame before anything is asked of the device: which avatars are in view, what each of
//! them has to compute again, and what all of them share.

use super::{
    ChangeTracker, Changes, Counters, RendererOptions, Skinning, Skip,
    atlas::{Arrangement, LevelInput, Seen, Slot, arrange},
    changes::View,
    damage::{Damage, regions_around},
    room::{Portion, PosePlaces, Room},
};
use crate::avatar::LowPass;
use crate::scene::{
    AvatarBounds, Camera, PartDependencies, PartSet, PixelRect, Posed, Visible,
    supersampling::low_pass,
};

/// An avatar in view.
pub struct AvatarInstance<'a> {
    /// Index of its pose in [`PlanInput::poses`], by which the renderer finds its buffers.
    pub index: usize,
    /// Its evaluated pose.
    pub posed: &'a Posed,
    /// The camera that sees it in the image that its layer is drawn into.
    pub camera: Camera,
    /// The part of the atlas that it must stay in; None in the image.
    pub slot: Option<PixelRect>,
    /// Samples a pixel of the frame's image along each axis, at least 1.
    pub samples: f64,
    /// The low-pass that it is drawn with.
    pub low_pass: LowPass,
    /// Longest side of its box in the frame's image, px; infinite where it crosses the near plane,
    /// 0 where sizes decide nothing.
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
    pub changes: Changes,
    /// Nearest and furthest depth along the camera's axis, metres.
    depth: [f64; 2],
    /// Area of its box in the frame's image, px²; None where it crosses the near plane.
    pixels: Option<f64>,
    /// Parts that may be in view; None where visibility does not matter.
    visible_parts: Option<PartSet>,
    /// Parts all outside the view.
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
    /// Pixels of the box around an avatar for each Gaussian of it that is drawn: of the avatar in
    /// view that has the fewest. Infinite where that decides nothing.
    pub pixels_a_gaussian: f64,
}

impl Layer<'_> {
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
    pub slots: Vec<Slot>,
}

/// The plan of one frame.
pub struct FramePlan<'a> {
    /// The avatars drawn as large as they are shown.
    pub image: Layer<'a>,
    /// The others; None where there are none.
    pub atlas: Option<Atlas<'a>>,
    /// Whether project, sort and raster run: something in the image has changed.
    pub redraw: bool,
    /// Avatars in the scene, in view or not.
    pub avatar_count: usize,
    /// A rectangle of the image around all that is drawn; the whole image without
    /// [`Skip::DAMAGE`]. What correctives move further than [`AvatarBounds::visible`] allows for is
    /// cut off there, in every frame alike; by tiles at the regions around it.
    pub drawn_rect: PixelRect,
}

/// Everything that decides what the next frame has to do.
#[derive(Clone, Copy)]
pub struct PlanInput<'a, 'pose> {
    /// One pose an avatar, at most [`RendererOptions::instances`].
    pub poses: &'a [&'pose Posed],
    /// The camera of the frame.
    pub camera: &'a Camera,
    /// The avatar's bounds.
    pub bounds: &'a AvatarBounds,
    /// Which parts' networks each part depends on.
    pub dependencies: &'a PartDependencies,
    /// The renderer's options.
    pub options: &'a RendererOptions,
    /// The renderer's room.
    pub room: Room,
    /// Whether the frame is submitted even if nothing has changed.
    pub always_submit: bool,
}

/// Whether a renderer has the optional stage of spherical harmonics, and the compute dispatches
/// of a frame that are not for each avatar.
#[derive(Clone, Copy, Debug)]
pub struct StageDispatches {
    /// Whether colours come from spherical harmonics.
    pub has_sh: bool,
    /// Dispatches of the sorts.
    pub sort: u64,
    /// Dispatches of the rasterizer.
    pub raster: u64,
}

/// The state that the last frame left. A renderer keeps one and asks it for the plan of each frame.
#[derive(Clone, Default)]
pub struct FrameState {
    /// One an avatar, in the order of the poses.
    trackers: Vec<ChangeTracker>,
    pose_places: PosePlaces,
    /// Indices of the avatars that the last frame drew; None before the first.
    last_drawn: Option<Vec<usize>>,
}

/// An avatar in view, before its place is known.
struct Candidate {
    /// Index of its pose.
    index: usize,
    /// Where it is.
    visible: Visible,
    /// How it may be drawn; None without supersampling.
    seen: Option<Seen>,
    /// The coarsest of its levels by which nothing is lost.
    near: usize,
}

/// Where an avatar in view is drawn.
struct Place<'a> {
    /// None in the image.
    slot: Option<&'a Slot>,
    /// Width and height of the atlas, px.
    atlas_size: [u32; 2],
    /// [`AvatarInstance::first_key`].
    first_key: u32,
    /// [`AvatarInstance::cache_start`].
    cache_start: u32,
}

impl FrameState {
    /// Plans the next frame and remembers it as drawn. Callers that fail to draw it must restore
    /// or reset this state, so that the next frame does not rely on it.
    pub fn plan<'pose>(&mut self, input: PlanInput<'_, 'pose>) -> FramePlan<'pose> {
        let PlanInput {
            poses,
            camera,
            bounds,
            options,
            ..
        } = input;
        let skip = options.skip;
        self.trackers
            .resize(options.instances, ChangeTracker::default());
        let whole = PixelRect::whole(camera.size);
        let mut drawn_rect = if skip.contains(Skip::DAMAGE) {
            PixelRect::EMPTY
        } else {
            whole
        };
        let mut candidates = Vec::with_capacity(poses.len());
        for (index, &posed) in poses.iter().enumerate() {
            if skip.contains(Skip::AVATARS) && bounds.is_outside(&posed.joints, camera) {
                continue;
            }
            let visible = bounds.visible(&posed.joints, camera);
            if visible.parts.is_empty() && skip.contains(Skip::AVATARS) {
                continue;
            }
            let has_margin = bounds.has_margin_for(&posed.input);
            drawn_rect = drawn_rect.union(if skip.contains(Skip::DAMAGE) && has_margin {
                visible.rect
            } else {
                whole
            });
            let seen = options.supersampling.is_on().then(|| {
                Seen::new(
                    bounds,
                    &visible,
                    LevelInput {
                        supersampling: options.supersampling,
                        before: self.trackers[index].near(),
                        coarser: options.detail.coarser,
                    },
                )
            });
            candidates.push(Candidate {
                index,
                visible,
                seen,
                near: 0,
            });
        }
        // All are measured, or none.
        let seen: Vec<Seen> = candidates.iter().filter_map(|own| own.seen).collect();
        let arrangement = if options.supersampling.is_on() {
            arrange(&seen, camera.size)
        } else {
            Arrangement::without_slots(candidates.len())
        };
        let portions = self.portions(&input, &mut candidates, &arrangement);
        let mut image = Vec::with_capacity(candidates.len());
        let mut atlas = Vec::new();
        let mut cache_start = 0;
        for (place_index, candidate) in candidates.into_iter().enumerate() {
            let slot = arrangement.slot_of[place_index].map(|slot| &arrangement.slots[slot]);
            let instances = if slot.is_some() {
                &mut atlas
            } else {
                &mut image
            };
            let first_key = instances.last().map_or(0, AvatarInstance::end_key);
            let place = Place {
                slot,
                atlas_size: arrangement.size,
                first_key,
                cache_start,
            };
            let instance = self.instance(input, candidate, portions[place_index], place);
            cache_start += instance.gaussians;
            instances.push(instance);
        }

        let mut in_view: Vec<_> = image.iter().chain(&atlas).map(|own| own.index).collect();
        in_view.sort_unstable();
        let others_in_view = self.last_drawn.as_ref() != Some(&in_view);
        let redraw = !skip.contains(Skip::FRAME)
            || others_in_view
            || image.iter().chain(&atlas).any(|own| own.changes.redraw);
        if redraw {
            for (index, tracker) in self.trackers.iter_mut().enumerate() {
                if in_view.binary_search(&index).is_err() {
                    tracker.mark_absent();
                }
            }
        }
        self.last_drawn = Some(in_view);
        // A frame that is not submitted runs no networks: they stay due.
        if redraw || input.always_submit {
            self.place_poses(image.iter_mut().chain(&mut atlas), input.room.posed);
            for instance in image.iter_mut().chain(&mut atlas) {
                let tracker = &mut self.trackers[instance.index];
                instance.networks = tracker.schedule_networks(
                    &instance.changes,
                    input.dependencies,
                    instance.visible_parts.as_ref(),
                    instance.correctives,
                );
                if redraw {
                    tracker.mark_drawn(&instance.changes, instance.cache_start);
                }
            }
        }
        let image = Layer {
            depth_range: depth_range(&image, camera),
            pixels_a_gaussian: if redraw && skip.contains(Skip::DEPTH) {
                pixels_a_gaussian(&image)
            } else {
                f64::INFINITY
            },
            instances: image,
            size: camera.size,
            drawn: regions_around(drawn_rect, camera.size),
        };
        let size = arrangement.size;
        let atlas = (!atlas.is_empty()).then(|| Atlas {
            layer: Layer {
                depth_range: depth_range(&atlas, camera),
                pixels_a_gaussian: f64::INFINITY,
                instances: atlas,
                size,
                drawn: PixelRect::whole(size),
            },
            slots: arrangement.slots,
        });
        FramePlan {
            image,
            atlas,
            redraw,
            avatar_count: poses.len(),
            drawn_rect,
        }
    }

    /// What is drawn of each avatar in view: at most what there is room for.
    fn portions(
        &self,
        input: &PlanInput,
        candidates: &mut [Candidate],
        arrangement: &Arrangement,
    ) -> Vec<Portion> {
        let mut portions: Vec<Portion> = candidates
            .iter_mut()
            .zip(&arrangement.slot_of)
            .map(|(candidate, slot)| {
                let slot = slot.map(|slot| &arrangement.slots[slot]);
                self.portion(input, candidate, slot)
            })
            .collect();
        let side = |place: usize| candidates[place].visible.longest_side();
        input.room.fit(&mut portions, side, input.bounds);
        portions
    }

    /// What is drawn of an avatar in view where there is room. Notes which level was near enough.
    fn portion(
        &self,
        input: &PlanInput,
        candidate: &mut Candidate,
        slot: Option<&Slot>,
    ) -> Portion {
        let PlanInput {
            bounds, options, ..
        } = input;
        let tracker = &self.trackers[candidate.index];
        // Levels are for what is small, at several samples a pixel.
        if let (Some(slot), Some(seen)) = (slot, candidate.seen) {
            let chosen = seen.chosen_for(bounds, slot.factor);
            candidate.near = chosen.near;
            if chosen.level > 0 {
                return Portion {
                    model: chosen.level,
                    level: 0,
                };
            }
        }
        let samples = slot.map_or(1.0, |slot| slot.factor * slot.factor);
        let pixels = || Some(samples * candidate.visible.pixels()?);
        let before = tracker.level();
        // Without levels in the file, each coarser one is half of the Gaussians.
        let coarser = slot.map_or(0, |_| options.detail.coarser as u32);
        let detail = options.detail.at_least(coarser);
        Portion {
            model: 0,
            level: detail.level(bounds.gaussians(), before, pixels),
        }
    }

    /// An avatar in view, whose networks are still to be scheduled.
    fn instance<'pose>(
        &mut self,
        input: PlanInput<'_, 'pose>,
        candidate: Candidate,
        portion: Portion,
        place: Place,
    ) -> AvatarInstance<'pose> {
        let PlanInput {
            bounds, options, ..
        } = input;
        let Candidate {
            index,
            visible,
            seen,
            near,
        } = candidate;
        let Place {
            slot,
            atlas_size,
            first_key,
            cache_start,
        } = place;
        let Portion { model, level } = portion;
        let posed = input.poses[index];
        let visible_parts = options.skip.contains(Skip::PARTS).then_some(visible.parts);
        let camera = slot.map_or(*input.camera, |slot| slot.camera(input.camera, atlas_size));
        let samples = slot.map_or(1.0, |slot| slot.factor);
        let view = View {
            camera,
            portion,
            near,
            slot: slot.copied(),
            cache_start,
        };
        let changes = self.trackers[index].update(posed, &view, options.skip);
        // The pose cache needs all parts: other cameras will see them.
        let culled_parts = match visible_parts {
            Some(visible) if changes.skinning != Skinning::ComputeAndStore => {
                input.dependencies.all() - visible
            }
            _ => PartSet::EMPTY,
        };
        AvatarInstance {
            index,
            posed,
            camera,
            slot: slot.map(Slot::rect),
            samples,
            low_pass: low_pass(bounds.filter(), options.filter, samples),
            side: seen.map_or(0.0, |seen| seen.side),
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

    /// Gives avatars that networks move their places in the pose buffer. Where one is new, all of
    /// the avatar's networks are due.
    fn place_poses<'own, 'pose: 'own>(
        &mut self,
        instances: impl Iterator<Item = &'own mut AvatarInstance<'pose>>,
        count: usize,
    ) {
        let mut posed: Vec<_> = instances.filter(|own| own.correctives).collect();
        posed.sort_unstable_by_key(|own| own.index);
        let indices: Vec<usize> = posed.iter().map(|own| own.index).collect();
        let places = self.pose_places.assign(&indices, count);
        for (instance, place) in posed.into_iter().zip(places) {
            instance.pose_place = place.number;
            if place.is_new {
                self.trackers[instance.index].lose_networks();
            }
        }
    }
}

impl Atlas<'_> {
    /// It holds one frame's avatars: nothing of the frame before is of use.
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

    /// The counts that are known before the frame is drawn. `gaussians`: how many one avatar has.
    pub fn counters(&self, gaussians: u32, stages: &StageDispatches) -> Counters {
        let avatars = self.avatar_count as u64;
        let drawn = self.instances().count() as u64;
        let mut counters = Counters {
            avatars,
            avatars_culled: avatars - drawn,
            gaussians: avatars * u64::from(gaussians),
            submitted: 1,
            ..Counters::default()
        };
        for instance in self.instances() {
            counters.skipped_by_detail += u64::from(gaussians - instance.gaussians);
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
            // Project, and sh where colours depend on the view, run once an avatar.
            counters.dispatches += drawn * (1 + u64::from(stages.has_sh));
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

/// [`Layer::pixels_a_gaussian`]; infinite where all avatars in view cross the near plane.
fn pixels_a_gaussian(instances: &[AvatarInstance]) -> f64 {
    instances
        .iter()
        .filter_map(|instance| Some(instance.pixels? / f64::from(instance.gaussians.max(1))))
        .fold(f64::INFINITY, f64::min)
}

/// A range of depths around all avatars in view, metres; any valid range where there are none.
fn depth_range(instances: &[AvatarInstance], camera: &Camera) -> [f64; 2] {
    instances
        .iter()
        .map(|instance| instance.depth)
        .reduce(|[low, high], [near, far]| [low.min(near), high.max(far)])
        .unwrap_or([camera.near, 2.0 * camera.near])
}
