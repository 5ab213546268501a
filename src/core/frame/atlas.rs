//! Which avatars are drawn larger than they are shown, and where: the atlas is an image with a slot
//! for each such avatar. Its slots are averaged and blended into the frame's image.
//!
//! Avatars that may pass through each other share a slot, and are sorted together as always. One
//! that may pass through an avatar that is drawn at its size is drawn at its size too. So slots
//! and whatever else meets them in the image are entirely before or behind each other.

use super::capacity::FEW;
use crate::scene::{
    AvatarBounds, Camera, PixelRect, PlaneRect, Supersampling, Visible,
    levels::{self, ChosenLevel},
};
use glam::UVec2;

/// Slots start at multiples of this, px, so that few tiles have splats of two: those are drawn in
/// their slot alone, and cost the other time.
const ALIGNMENT: u32 = 16;
/// Longest side of an atlas, px: the least that a Vulkan device may have.
const LONGEST: u32 = 4096;
/// How often the range is halved in which the most that a slot may have is looked for.
const HALVINGS: usize = 32;
/// Pixels that an atlas may have where the image has fewer.
const LEAST_PIXELS: u64 = 1 << 22;

/// The options and the history that decide an avatar's level, besides its size.
#[derive(Clone, Copy, Debug)]
pub struct LevelInput {
    /// Levels are for avatars whose size decides how they are drawn.
    pub supersampling: Supersampling,
    /// The level that was near enough in the last frame.
    pub before: usize,
    /// How many levels coarser than that it should be ([`levels::choose`]).
    pub coarser: usize,
}

/// The part of the image that an avatar in view covers, and how large it should be drawn.
#[derive(Clone, Copy, Debug)]
pub struct AvatarFootprint {
    /// Encloses all that is drawn of it. None if it has no bounds; such avatars are drawn as large
    /// as they are shown.
    pub around: Option<PlaneRect>,
    /// Nearest and furthest depth, metres.
    pub depth: [f64; 2],
    /// Longest side of its box in the image without a margin, px; infinite if it crosses the near
    /// plane.
    pub side: f64,
    /// The largest factor by which it may be enlarged, given its size; at least 1.
    pub most: f64,
    /// The level that it is drawn from in a slot of its own, and its samples there.
    pub chosen: ChosenLevel,
    /// The input that the level was chosen from.
    pub input: LevelInput,
}

impl AvatarFootprint {
    /// The footprint of an avatar whose visibility is known.
    pub fn new(bounds: &AvatarBounds, visible: &Visible, input: LevelInput) -> Self {
        let side = visible.longest_side();
        let most = input.supersampling.factor(side);
        let chosen = match input.supersampling {
            Supersampling::BySize if most > 1.0 => {
                levels::choose(bounds.levels(), side, most, input.before, input.coarser)
            }
            _ => ChosenLevel {
                near: 0,
                level: 0,
                samples: most,
            },
        };
        Self {
            around: visible.around,
            depth: visible.depth,
            side,
            most,
            chosen,
            input,
        }
    }

    /// The level for a slot with this factor, which is smaller than its own in a full atlas, and
    /// larger in a slot that it shares with avatars that need more samples.
    pub fn chosen_for(&self, bounds: &AvatarBounds, factor: f64) -> ChosenLevel {
        let LevelInput {
            supersampling,
            before,
            coarser,
        } = self.input;
        match supersampling {
            Supersampling::BySize if factor != self.chosen.samples => {
                levels::choose_with(bounds.levels(), self.side, factor, before, coarser)
            }
            _ => self.chosen,
        }
    }
}

/// A part of the image, drawn larger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtlasSlot {
    /// The part of the image's plane that it holds, px of the image.
    pub around: PlaneRect,
    /// Pixels of the atlas in a pixel of the image, each way; above 1.
    pub factor: f64,
    /// Column and row in the atlas of its first pixel.
    pub at: UVec2,
    /// Whether it is blended behind what the image holds, not over it.
    pub behind: bool,
}

impl AtlasSlot {
    /// Its pixels in the atlas.
    pub fn rect(&self) -> PixelRect {
        PixelRect {
            min: self.at,
            max: self.at + texels(self.around.sides(), self.factor),
        }
    }

    /// The pixels of an image of a size that it is averaged into.
    pub fn shown(&self, size: [u32; 2]) -> PixelRect {
        self.around.within(size)
    }

    /// The camera that sees the image's plane as its slot holds it. `size`: the atlas's.
    pub fn camera(&self, camera: &Camera, size: [u32; 2]) -> Camera {
        let factor = self.factor;
        Camera {
            focal: factor * camera.focal,
            center: factor * (camera.center - self.around.min.as_dvec2()) + self.at.as_dvec2(),
            size,
            ..*camera
        }
    }
}

/// Width and height of an image with these sides, px, enlarged by a factor, in whole pixels.
fn texels(sides: UVec2, factor: f64) -> UVec2 {
    (factor * sides.as_dvec2()).ceil().as_uvec2()
}

/// Where avatars are drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrangement {
    /// Index of the slot of each avatar; None for avatars drawn as large as they are shown.
    pub slot_of: Vec<Option<usize>>,
    /// The slots, in the order in which they are blended.
    pub slots: Vec<AtlasSlot>,
    /// Width and height of the atlas, px; 0 without slots.
    pub size: [u32; 2],
}

impl Arrangement {
    /// This many avatars, each drawn as large as it is shown.
    pub fn without_slots(avatars: usize) -> Self {
        Self {
            slot_of: vec![None; avatars],
            ..Self::default()
        }
    }

    /// The slot of an avatar; None if it is drawn as large as it is shown.
    pub fn slot(&self, avatar: usize) -> Option<&AtlasSlot> {
        self.slot_of[avatar].map(|slot| &self.slots[slot])
    }
}

/// Avatars that share a slot, or one avatar that is drawn as large as it is shown.
struct AvatarGroup {
    members: Vec<usize>,
    around: Option<PlaneRect>,
    depth: [f64; 2],
    factor: f64,
    /// The smallest [`AvatarFootprint::most`] of its members.
    most: f64,
    behind: bool,
}

impl AvatarGroup {
    /// A group of one avatar.
    fn new(index: usize, footprint: &AvatarFootprint) -> Self {
        let (factor, most) = match footprint.around {
            Some(_) => (footprint.chosen.samples, footprint.most),
            None => (1.0, 1.0),
        };
        Self {
            members: vec![index],
            around: footprint.around,
            depth: footprint.depth,
            factor,
            most,
            behind: false,
        }
    }

    fn meets(&self, other: &Self) -> bool {
        match (self.around, other.around) {
            (Some(own), Some(others)) => own.meets(others),
            _ => true,
        }
    }

    fn is_small(&self) -> bool {
        self.factor > 1.0
    }

    /// Width and height of its slot at a factor, px of the atlas.
    fn slot_size(&self, factor: f64) -> UVec2 {
        let sides = self.around.map_or(UVec2::ZERO, PlaneRect::sides);
        texels(sides, factor).map(|side| side.next_multiple_of(ALIGNMENT))
    }

    /// The pixels of its slot at a factor; 0 if it needs no slot.
    fn pixels(&self, factor: f64) -> u64 {
        let size = self.slot_size(factor);
        if factor > 1.0 {
            u64::from(size.x) * u64::from(size.y)
        } else {
            0
        }
    }

    /// Its factor if a slot may show at most `most` pixels.
    fn factor_within(&self, most: f64) -> f64 {
        let sides = self.around.map_or(UVec2::ONE, PlaneRect::sides).as_dvec2();
        // Rounding must not make a side longer than the longest.
        let longest = f64::from(LONGEST - 1) / sides.max_element();
        let factor = self.factor.min(longest);
        factor.min((most / sides.element_product()).sqrt()).max(1.0)
    }

    /// Whether some of one is as far as some of the other.
    fn passes_through(&self, other: &Self) -> bool {
        self.meets(other) && self.depth[0] < other.depth[1] && other.depth[0] < self.depth[1]
    }

    fn is_behind(&self, other: &Self) -> bool {
        self.depth[0] >= other.depth[1]
    }

    fn join(&mut self, other: Self) {
        self.members.extend(other.members);
        self.around = match (self.around, other.around) {
            (Some(own), Some(others)) => Some(own.union(others)),
            _ => None,
        };
        self.depth = [
            self.depth[0].min(other.depth[0]),
            self.depth[1].max(other.depth[1]),
        ];
        // As many samples as the one that needs most of them: finer levels do for the others. With
        // fewer some would be too fat.
        self.most = self.most.min(other.most);
        self.factor = self.factor.max(other.factor).min(self.most);
    }
}

/// Arranges avatars in view. `size`: of the image, px.
pub fn arrange(footprints: &[AvatarFootprint], size: [u32; 2]) -> Arrangement {
    let mut groups: Vec<AvatarGroup> = footprints
        .iter()
        .enumerate()
        .map(|(index, footprint)| AvatarGroup::new(index, footprint))
        .collect();
    let small = groups.iter().filter(|group| group.is_small()).count();
    let mut pixels = most_pixels(size, small);
    while groups.iter().any(AvatarGroup::is_small) {
        while join_small(&mut groups) {}
        if !settle_sides(&mut groups) {
            continue;
        }
        if shrink(&mut groups, pixels) {
            continue;
        }
        match pack(&groups, footprints.len()) {
            Some(arrangement) => return arrangement,
            // The pixels suffice, but not for rows of these shapes.
            None => pixels = pixels / 4 * 3,
        }
    }
    Arrangement::without_slots(footprints.len())
}

/// Pixels that an atlas may have for this many small avatars in an image of this size. A crowd gets
/// fewer, down to a quarter: pixels take most of its time, and few samples suffice
/// (docs/experiments/050).
fn most_pixels(size: [u32; 2], small: usize) -> u64 {
    let all = LEAST_PIXELS.max(u64::from(size[0]) * u64::from(size[1]));
    (all * FEW as u64 / small.max(1) as u64).clamp(all / 4, all)
}

/// Joins small groups that may pass through each other. Returns whether some did: they have grown,
/// and may meet others now.
fn join_small(groups: &mut Vec<AvatarGroup>) -> bool {
    groups.sort_by(|a, b| a.depth[0].total_cmp(&b.depth[0]));
    let before = groups.len();
    let mut at = 0;
    while at < groups.len() {
        let mut other = at + 1;
        // Those that follow begin further away.
        while other < groups.len() && groups[other].depth[0] < groups[at].depth[1] {
            if groups[at].is_small()
                && groups[other].is_small()
                && groups[at].passes_through(&groups[other])
            {
                let other = groups.remove(other);
                groups[at].join(other);
            } else {
                other += 1;
            }
        }
        at += 1;
    }
    groups.len() < before
}

/// Reduces factors until no side is longer than an atlas's and all groups together have at most
/// `pixels`. The largest groups shrink alike, so that no factor jumps as avatars come and go.
/// Returns whether a group is drawn as large as it is shown from now on.
fn shrink(groups: &mut [AvatarGroup], pixels: u64) -> bool {
    let small = || groups.iter().filter(|group| group.is_small());
    let fits = |most: f64| {
        let own = |group: &AvatarGroup| group.pixels(group.factor_within(most));
        small().map(own).sum::<u64>() <= pixels
    };
    // All that a slot may have, then what is known to fit and what is not.
    let mut most = f64::from(LONGEST) * f64::from(LONGEST);
    if !fits(most) {
        let mut least = 0.0;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (least + most);
            if fits(middle) {
                least = middle;
            } else {
                most = middle;
            }
        }
        most = least;
    }
    let mut is_shown = false;
    for group in groups.iter_mut().filter(|group| group.is_small()) {
        group.factor = group.factor_within(most);
        is_shown |= !group.is_small();
    }
    is_shown
}

/// Says of each small group whether it lies behind the large ones that it meets. A group that is
/// neither before nor behind them all is drawn as large as it is shown from now on; then this
/// returns false, and the groups have to be looked at again.
fn settle_sides(groups: &mut [AvatarGroup]) -> bool {
    let mut settled = true;
    for at in 0..groups.len() {
        if !groups[at].is_small() {
            continue;
        }
        let large = || {
            let group = &groups[at];
            groups
                .iter()
                .filter(move |other| !other.is_small() && other.meets(group))
        };
        let behind = large().any(|other| groups[at].is_behind(other));
        let apart = large().all(|other| {
            if behind {
                groups[at].is_behind(other)
            } else {
                other.is_behind(&groups[at])
            }
        });
        groups[at].behind = behind;
        if !apart {
            groups[at].factor = 1.0;
            settled = false;
        }
    }
    // What is blended over the image covers what is blended behind it.
    for at in 0..groups.len() {
        let covers = |other: &AvatarGroup| {
            other.is_small()
                && !other.behind
                && other.meets(&groups[at])
                && other.is_behind(&groups[at])
        };
        if groups[at].is_small() && groups[at].behind && groups.iter().any(covers) {
            groups[at].factor = 1.0;
            settled = false;
        }
    }
    settled
}

/// Places the slots of small groups, which must not be too wide, in rows, the tallest first. None
/// if they do not fit.
fn pack(groups: &[AvatarGroup], count: usize) -> Option<Arrangement> {
    let mut arrangement = Arrangement::without_slots(count);
    let mut small: Vec<&AvatarGroup> = groups.iter().filter(|group| group.is_small()).collect();
    // Behind the image the nearest comes first, over it the furthest.
    small.sort_by(|a, b| {
        b.behind.cmp(&a.behind).then_with(|| {
            if a.behind {
                a.depth[0].total_cmp(&b.depth[0])
            } else {
                b.depth[0].total_cmp(&a.depth[0])
            }
        })
    });
    let sizes: Vec<UVec2> = small
        .iter()
        .map(|group| group.slot_size(group.factor))
        .collect();
    for group in small {
        for &member in &group.members {
            arrangement.slot_of[member] = Some(arrangement.slots.len());
        }
        arrangement.slots.push(AtlasSlot {
            around: group.around?,
            factor: group.factor,
            at: UVec2::ZERO,
            behind: group.behind,
        });
    }
    let widest = sizes.iter().map(|size| size.x).max()?;
    let pixels: u64 = sizes
        .iter()
        .map(|size| u64::from(size.x) * u64::from(size.y))
        .sum();
    let width = widest.max((pixels as f64).sqrt() as u32);
    let mut order: Vec<usize> = (0..arrangement.slots.len()).collect();
    order.sort_by_key(|&slot| std::cmp::Reverse(sizes[slot].y));
    let mut next = UVec2::ZERO;
    let mut row_height = 0;
    let mut used = UVec2::ZERO;
    for slot in order {
        let size = sizes[slot];
        let slot = &mut arrangement.slots[slot];
        if next.x + size.x > width {
            next = UVec2::new(0, next.y + row_height);
            row_height = 0;
        }
        slot.at = next;
        row_height = row_height.max(size.y);
        next.x += size.x;
        used = used.max(slot.at + size);
    }
    arrangement.size = used.into();
    (used.y <= LONGEST).then_some(arrangement)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::IVec2;

    const SIZE: [u32; 2] = [1000, 800];

    /// An avatar of 50 × 100 px at a place, a metre deep.
    fn seen(x: i32, y: i32, depth: f64, factor: f64) -> AvatarFootprint {
        let min = IVec2::new(x, y);
        AvatarFootprint {
            around: Some(PlaneRect {
                min,
                max: min + IVec2::new(50, 100),
            }),
            depth: [depth, depth + 1.0],
            side: 100.0,
            most: factor,
            chosen: ChosenLevel {
                near: 0,
                level: 0,
                samples: factor,
            },
            input: LevelInput {
                supersampling: Supersampling::BySize,
                before: 0,
                coarser: 0,
            },
        }
    }

    /// A large one in the middle of the image.
    fn large(depth: f64) -> AvatarFootprint {
        AvatarFootprint {
            around: Some(PlaneRect {
                min: IVec2::new(300, 0),
                max: IVec2::new(700, 800),
            }),
            ..seen(0, 0, depth, 1.0)
        }
    }

    fn slots(seen: &[AvatarFootprint]) -> Vec<Option<usize>> {
        arrange(seen, SIZE).slot_of
    }

    #[test]
    fn avatars_that_may_pass_through_each_other_share_a_slot() {
        // The third stands behind the first two, the fourth apart.
        let all = [
            seen(10, 10, 5.0, 4.0),
            seen(40, 30, 5.5, 2.0),
            seen(20, 10, 9.0, 4.0),
            seen(500, 10, 5.0, 4.0),
        ];
        let arranged = arrange(&all, SIZE);
        let [a, b, c, d] = arranged.slot_of[..] else {
            panic!("four avatars")
        };
        assert!(a == b && a != c && c != d && a != d && arranged.slots.len() == 3);
        let shared = arranged.slots[a.expect("in a slot")];
        assert_eq!(shared.factor, 2.0);
        assert_eq!(shared.around.sides(), UVec2::new(80, 120));
        // Over what the image holds the furthest comes first.
        assert!(c < a);
    }

    #[test]
    fn slots_do_not_overlap_and_hold_what_they_show() {
        let all: Vec<AvatarFootprint> = (0..64)
            .map(|k| {
                seen(
                    90 * (k % 11) - 20,
                    110 * (k / 11) - 30,
                    5.0 + f64::from(k),
                    4.0,
                )
            })
            .collect();
        let arranged = arrange(&all, SIZE);
        assert_eq!(arranged.slots.len(), 64);
        for (at, slot) in arranged.slots.iter().enumerate() {
            let rect = slot.rect();
            assert!(rect.max.cmple(UVec2::from(arranged.size)).all());
            assert!((rect.min % ALIGNMENT).cmpeq(UVec2::ZERO).all());
            for other in &arranged.slots[..at] {
                let other = other.rect();
                let apart = rect.min.cmpge(other.max).any() || other.min.cmpge(rect.max).any();
                assert!(apart, "{rect:?} and {other:?}");
            }
            assert!(slot.shown(SIZE).max.cmple(UVec2::from(SIZE)).all());
        }
    }

    #[test]
    fn small_avatars_are_before_or_behind_large_ones() {
        let before = arrange(&[large(5.0), seen(400, 100, 2.0, 4.0)], SIZE);
        assert!(before.slot_of == [None, Some(0)] && !before.slots[0].behind);
        let behind = arrange(&[seen(400, 100, 9.0, 4.0), large(5.0)], SIZE);
        assert!(behind.slot_of == [Some(0), None] && behind.slots[0].behind);
        // Inside the large one, between two of them, and beside one at its depth.
        assert_eq!(slots(&[large(5.0), seen(400, 100, 5.5, 4.0)]), [None, None]);
        let between = [large(5.0), seen(400, 100, 7.0, 4.0), large(9.0)];
        assert_eq!(slots(&between), [None, None, None]);
        assert_eq!(
            slots(&[large(5.0), seen(0, 100, 5.5, 4.0)]),
            [None, Some(0)]
        );
    }

    #[test]
    fn what_is_behind_comes_before_what_is_before() {
        let all = [
            large(5.0),
            seen(400, 100, 1.0, 4.0),
            seen(420, 100, 2.5, 4.0),
            seen(400, 100, 20.0, 4.0),
            seen(420, 100, 10.0, 4.0),
        ];
        // Behind the image the nearest comes first, over it the furthest.
        assert_eq!(slots(&all), [None, Some(3), Some(2), Some(1), Some(0)]);
    }

    #[test]
    fn what_does_not_fit_is_drawn_less_large() {
        let wide = AvatarFootprint {
            around: Some(PlaneRect {
                min: IVec2::new(0, 0),
                max: IVec2::new(1000, 100),
            }),
            ..seen(0, 0, 5.0, 4.0)
        };
        let factors = |count: usize| {
            let all: Vec<AvatarFootprint> = (0..count)
                .map(|k| AvatarFootprint {
                    depth: [k as f64, k as f64 + 0.5],
                    ..wide
                })
                .collect();
            let arranged = arrange(&all, SIZE);
            let factors = arranged.slots.iter().map(|slot| slot.factor);
            factors.collect::<Vec<_>>()
        };
        assert_eq!([0, 1, 2].map(factors), [vec![], vec![4.0], vec![4.0; 2]]);
        // All alike, as large as there is room for.
        for (count, near) in [(3, 3.6), (9, 2.1), (12, 1.8)] {
            let factors = factors(count);
            let wrong = |factor: &&f64| **factor > near + 0.1 || **factor < near - 0.1;
            assert_eq!(factors.len(), count);
            assert_eq!(factors.iter().find(wrong), None, "{factors:?}");
        }
        // None is worth a slot.
        assert!(factors(60).is_empty());
        // One that is too long alone.
        let long = AvatarFootprint {
            around: Some(PlaneRect {
                min: IVec2::new(-1000, 0),
                max: IVec2::new(2000, 10),
            }),
            ..wide
        };
        let arranged = arrange(&[long], SIZE);
        assert!(arranged.size[0] <= LONGEST && arranged.slots[0].factor > 1.3);
        let unbounded = AvatarFootprint {
            around: None,
            ..wide
        };
        assert_eq!(slots(&[unbounded]), [None]);
    }

    #[test]
    fn a_crowd_has_fewer_pixels_and_no_steps() {
        let pixels = |small| most_pixels(SIZE, small);
        assert_eq!([0, 1, 16].map(pixels), [LEAST_PIXELS; 3]);
        assert_eq!([64, 1000].map(pixels), [LEAST_PIXELS / 4; 2]);
        for small in 16..64 {
            let share = pixels(small + 1) as f64 / pixels(small) as f64;
            assert!((0.94..1.0).contains(&share), "{small}: {share}");
        }
        assert_eq!(most_pixels([4096, 4096], 64), 1 << 22);
    }

    #[test]
    fn a_slots_camera_sees_its_part_of_the_plane() {
        let camera = Camera::orbit(glam::DVec3::ZERO, 0.3, 0.1, 4.0, 0.7, SIZE);
        let arranged = arrange(&[seen(100, 40, 5.0, 4.0), seen(600, 40, 5.0, 2.0)], SIZE);
        for slot in &arranged.slots {
            let own = slot.camera(&camera, arranged.size);
            let p = glam::DVec3::new(0.3, -0.2, 3.0);
            let in_image = camera.project(p) - slot.around.min.as_dvec2();
            let in_slot = own.project(p) - slot.at.as_dvec2();
            assert!((in_slot - slot.factor * in_image).length() < 1e-9);
        }
    }
}
