//! What a frame is made of, before anything is asked of the device: posed avatars and a camera go in; which of them are in view, what
//! each needs, and what all of them share come out.

use super::{Body, Camera, Counters, Extent, Needed, Needs, PartSet, Place, Plan, Posed, RendererOptions, Skip, detail, extent};
use glam::UVec2;

/// An avatar in view.
pub struct Actor<'a> {
    /// Which of the renderer's places it has: that of its pose in what [`Scene::next`] was given.
    pub number: usize,
    pub posed: &'a Posed,
    /// Of detail, and how many Gaussians that is.
    pub level: u32,
    pub drawn: u32,
    /// Where among the splats and keys of all avatars its own start: an even number, so that two keys of a word are of one avatar.
    pub first: u32,
    pub needed: Needed,
    /// Parts that may be in the view, where it matters.
    seen: Option<PartSet>,
    /// Parts all outside the view.
    pub outside: PartSet,
    /// Networks that run.
    pub networks: PartSet,
}

impl Actor<'_> {
    /// Where the next one's splats and keys start.
    fn end(&self) -> u32 {
        self.first + slots(self.drawn)
    }
}

/// What one frame draws.
pub struct Staged<'a> {
    pub actors: Vec<Actor<'a>>,
    /// `splats`, `sort` and `raster`: something in the picture has changed.
    pub view: bool,
    /// Nearest and furthest that is expected, metres.
    pub depth: [f64; 2],
    /// What the depth surface covers, where one is worth drawing.
    pub place: Option<Place>,
    /// Avatars in the scene, whether in view or not.
    pub avatars: usize,
    /// Lower and upper corner of a box in the picture around all that is drawn, but for correctives beyond what [`Extent::visible`] expects,
    /// px: all of the picture where nobody looked.
    pub area: [UVec2; 2],
}

/// Remembers what the last frame showed.
#[derive(Clone, Default)]
pub struct Scene {
    plans: Vec<Plan>,
    /// Those that it drew.
    in_view: Option<Vec<usize>>,
}

impl Scene {
    /// What the next frame needs, but for what `options` let it leave out. `surface`: whether there is a depth surface to draw;
    /// `presented`: whether the frame is submitted even where it needs nothing.
    pub fn next<'a>(
        &mut self,
        poses: &[&'a Posed],
        camera: &Camera,
        (extent, needs, options): (&Extent, &Needs, &RendererOptions),
        (surface, presented): (bool, bool),
    ) -> Staged<'a> {
        self.plans.resize(options.actors, Plan::default());
        let skip = options.skip;
        let mut actors = Vec::with_capacity(poses.len());
        let whole = [UVec2::ZERO, camera.size.into()];
        let mut area = if skip.contains(Skip::AREA) { extent::NOWHERE } else { whole };
        for (number, &posed) in poses.iter().enumerate() {
            let looks = skip.intersects(Skip::AVATARS | Skip::PARTS | Skip::AREA);
            let visible = looks.then(|| extent.visible(&posed.joints, camera));
            if skip.contains(Skip::AVATARS) && visible.as_ref().is_some_and(|visible| visible.parts.is_empty()) {
                continue;
            }
            area = extent::around(area, visible.as_ref().filter(|_| skip.contains(Skip::AREA)).map_or(whole, |visible| visible.area));
            let seen = visible.filter(|_| skip.contains(Skip::PARTS)).map(|visible| visible.parts);
            let pixels = || extent.pixels(&posed.joints, camera);
            let level = options.detail.level(extent.gaussians(), self.plans[number].level(), pixels);
            let drawn = detail::drawn(extent.gaussians() as u32, level);
            let needed = self.plans[number].next(posed, camera, skip, level);
            let outside = seen.filter(|_| needed.body != Body::Keep).map_or(PartSet::EMPTY, |seen| needs.all() - seen);
            let first = actors.last().map_or(0, Actor::end);
            actors.push(Actor { number, posed, level, drawn, first, needed, seen, outside, networks: PartSet::EMPTY });
        }
        let in_view: Vec<_> = actors.iter().map(|actor| actor.number).collect();
        let others = !skip.contains(Skip::FRAME) || self.in_view.as_ref() != Some(&in_view);
        let view = others || actors.iter().any(|actor| actor.needed.view);
        self.in_view = Some(in_view);
        for actor in actors.iter_mut().filter(|_| view || presented) {
            let plan = &mut self.plans[actor.number];
            actor.networks = plan.networks(&actor.needed, needs, actor.seen.as_ref());
            if view {
                plan.shown(&actor.needed);
            }
        }
        let place = (surface && !actors.is_empty()).then(|| Place::new(camera.size, screen(&actors, extent, camera)));
        Staged { depth: depth(&actors, extent, camera), actors, view, place, avatars: poses.len(), area }
    }
}

impl Staged<'_> {
    /// Keys of all avatars in view.
    pub fn keys(&self) -> u32 {
        self.actors.last().map_or(0, Actor::end)
    }

    /// What is known of the frame before it is drawn. `harmonics`, `surface`: whether it has those stages; `sort`: dispatches of the sort.
    pub fn counters(&self, gaussians: u32, (harmonics, surface, sort): (bool, bool, usize), raster: u64) -> Counters {
        let drawn = self.actors.len() as u64;
        let sum = |of: &dyn Fn(&Actor) -> usize| self.actors.iter().map(of).sum::<usize>() as u64;
        let posed = sum(&|actor| usize::from(!actor.networks.is_empty()));
        let kept = sum(&|actor| if self.view && actor.needed.body == Body::Kept { actor.drawn as usize } else { 0 });
        let view = drawn * (1 + u64::from(harmonics)) + if drawn > 0 { u64::from(surface) + sort as u64 } else { 0 };
        Counters {
            avatars: self.avatars as u64,
            avatars_culled: self.avatars as u64 - drawn,
            gaussians: self.avatars as u64 * u64::from(gaussians),
            thinned: sum(&|actor| (gaussians - actor.drawn) as usize),
            networks: sum(&|actor| actor.networks.len()),
            parts_outside: sum(&|actor| actor.outside.len()),
            kept,
            dispatches: posed + if self.view { view + raster } else { 0 },
            submitted: 1,
            ..Counters::default()
        }
    }
}

/// Places of an avatar that draws so many Gaussians, among splats and keys.
pub fn slots(drawn: u32) -> u32 {
    drawn.next_multiple_of(2)
}

/// A box in the picture around all of them.
fn screen(actors: &[Actor], extent: &Extent, camera: &Camera) -> [UVec2; 2] {
    let boxes = actors.iter().map(|actor| extent.screen(&actor.posed.joints, camera));
    // Those that are empty lie anywhere.
    let full = boxes.filter(|[min, max]| min.cmplt(*max).all());
    full.reduce(|[low, high], [min, max]| [low.min(min), high.max(max)]).unwrap_or_default()
}

/// A range of depths around all of them; any where there are none.
fn depth(actors: &[Actor], extent: &Extent, camera: &Camera) -> [f64; 2] {
    let ranges = actors.iter().map(|actor| extent.depth(&actor.posed.joints, camera));
    ranges.reduce(|[low, high], [near, far]| [low.min(near), high.max(far)]).unwrap_or([camera.near, 2.0 * camera.near])
}
