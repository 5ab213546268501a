//! How many Gaussians a frame can draw. A crowd's buffers hold fewer than those of all its avatars:
//! if a frame would draw more, the avatars with the most Gaussians a pixel are drawn coarser.

use super::{RendererOptions, Unusable};
use crate::scene::{AvatarBounds, detail};
use std::{cmp::Ordering, collections::BinaryHeap};

/// More avatars than this are a crowd. With up to this many, a frame can draw all Gaussians of
/// each, unless options say otherwise, and an atlas may have all its pixels.
pub(super) const FEW: usize = 16;

/// The part of an avatar that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Portion {
    /// Which of the avatar's levels ([`crate::scene::levels`]); 0 is the avatar itself.
    pub model: usize,
    /// How far that is thinned out ([`detail`]).
    pub level: u32,
}

impl Portion {
    /// The smallest portion of an avatar.
    fn coarsest(bounds: &AvatarBounds) -> Self {
        Self {
            model: bounds.levels().len(),
            level: detail::COARSEST,
        }
    }

    /// The next coarser portion: the avatar's levels come before thinning out.
    fn coarser(self, bounds: &AvatarBounds) -> Option<Self> {
        if self.model < bounds.levels().len() {
            Some(Self {
                model: self.model + 1,
                level: 0,
            })
        } else {
            (self.level < detail::COARSEST).then(|| Self {
                level: self.level + 1,
                ..self
            })
        }
    }

    /// Gaussians that are drawn.
    pub fn gaussians(self, bounds: &AvatarBounds) -> u32 {
        let all = match self.model {
            0 => bounds.gaussians(),
            model => bounds.levels()[model - 1].gaussians,
        };
        detail::gaussian_count(all as u32, self.level)
    }

    /// Whether networks move them.
    pub fn correctives(self, bounds: &AvatarBounds) -> bool {
        self.model == 0 || bounds.levels()[self.model - 1].correctives
    }
}

/// Gaussians of portions of an avatar.
struct Needs {
    whole: u64,
    coarsest: u64,
    /// Of the smallest that networks move, at least 1.
    fewest: u64,
}

impl Needs {
    fn of(bounds: &AvatarBounds) -> Self {
        let count = |portion: Portion| u64::from(portion.gaussians(bounds));
        let whole = Portion { model: 0, level: 0 };
        let portions = std::iter::successors(Some(whole), |portion| portion.coarser(bounds));
        let moved = portions.filter(|portion| portion.correctives(bounds));
        let fewest = moved.map(|portion| count(portion).max(1)).min();
        // Every level of every avatar may also be thinned out.
        let thinned = count(Portion {
            level: detail::COARSEST,
            ..whole
        });
        Self {
            whole: count(whole),
            coarsest: count(Portion::coarsest(bounds)),
            fewest: fewest.unwrap_or(u64::MAX).min(thinned),
        }
    }
}

/// How much a renderer's buffers can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Gaussians of all avatars that a frame draws, those counted that pad them
    /// ([`Portion::gaussians`]).
    pub gaussians: u32,
    /// Avatars that networks move, each with its place in the pose buffer.
    pub posed: usize,
}

impl Capacity {
    /// The capacity that a renderer with these options needs for as many people of one avatar as it
    /// may draw.
    ///
    /// # Errors
    /// Those of [`Self::of`].
    pub fn new(options: &RendererOptions, bounds: &AvatarBounds) -> Result<Self, Unusable> {
        Self::of(options, std::iter::repeat_n(bounds, options.instances))
    }

    /// The capacity that a renderer with these options needs for people of avatars with these
    /// bounds.
    ///
    /// # Errors
    /// When [`RendererOptions::gaussians`] is too few for the coarsest portion of each, or for one
    /// of them whole.
    pub fn of<'a>(
        options: &RendererOptions,
        people: impl Iterator<Item = &'a AvatarBounds>,
    ) -> Result<Self, Unusable> {
        let [mut all, mut coarsest, mut largest, mut count] = [0u64; 4];
        let mut fewest = u64::MAX;
        for bounds in people {
            let needs = Needs::of(bounds);
            all += needs.whole;
            coarsest += needs.coarsest;
            largest = largest.max(needs.whole);
            fewest = fewest.min(needs.fewest);
            count += 1;
        }
        let least = coarsest.max(largest);
        let gaussians = match options.gaussians {
            Some(most) => all.min(most.into()),
            None if options.instances > FEW => all.min((4 * largest).max(least)),
            None => all,
        };
        if gaussians < least {
            return Err(Unusable {
                what: "the number of Gaussians of a frame".into(),
                found: gaussians.to_string(),
                expected: format!("at least {least}, for {count} of these avatars"),
            });
        }
        Ok(Self {
            gaussians: gaussians.try_into().unwrap_or(u32::MAX),
            posed: (gaussians / fewest.max(1)).min(count) as usize,
        })
    }

    /// Whether it suffices where `other` does.
    pub fn holds(&self, other: &Self) -> bool {
        self.gaussians >= other.gaussians && self.posed >= other.posed
    }

    /// One that suffices where either does.
    pub fn union(self, other: Self) -> Self {
        Self {
            gaussians: self.gaussians.max(other.gaussians),
            posed: self.posed.max(other.posed),
        }
    }

    /// Capacity for this many whole avatars, for plans that are never drawn.
    pub fn unlimited(avatars: usize) -> Self {
        Self {
            gaussians: u32::MAX,
            posed: avatars,
        }
    }

    /// Makes portions coarser until all fit, always that of the avatar with the most Gaussians a
    /// pixel of its box. `side`: the longest side of an avatar in the image, px; called only if
    /// portions don't fit. `bounds`: of each portion's avatar.
    pub fn fit(
        &self,
        portions: &mut [Portion],
        side: impl Fn(usize) -> f64,
        bounds: &[&AvatarBounds],
    ) {
        let count = |avatar: usize, portion: Portion| portion.gaussians(bounds[avatar]);
        let portions_of = portions.iter().enumerate();
        let mut total: u64 = portions_of
            .map(|(avatar, &portion)| u64::from(count(avatar, portion)))
            .sum();
        if total <= self.gaussians.into() {
            return;
        }
        let sides: Vec<f64> = (0..portions.len()).map(side).collect();
        let crowded = |avatar: usize, portion: Portion| Crowded {
            density: f64::from(count(avatar, portion)) / (sides[avatar] * sides[avatar]),
            avatar,
        };
        let mut densest: BinaryHeap<Crowded> = (0..portions.len())
            .map(|avatar| crowded(avatar, portions[avatar]))
            .collect();
        while total > self.gaussians.into()
            && let Some(Crowded { avatar, .. }) = densest.pop()
        {
            if let Some(coarser) = portions[avatar].coarser(bounds[avatar]) {
                total -= u64::from(count(avatar, portions[avatar]));
                total += u64::from(count(avatar, coarser));
                portions[avatar] = coarser;
                densest.push(crowded(avatar, coarser));
            }
        }
    }
}

/// An avatar, ordered by its density.
struct Crowded {
    /// Gaussians a pixel of its box.
    density: f64,
    avatar: usize,
}

impl Ord for Crowded {
    fn cmp(&self, other: &Self) -> Ordering {
        let density = self.density.total_cmp(&other.density);
        density.then(self.avatar.cmp(&other.avatar))
    }
}

impl PartialOrd for Crowded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Crowded {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Crowded {}

/// The places of the pose buffer. Each holds one avatar's features and node displacements.
#[derive(Clone, Debug, Default)]
pub struct PosePlaces {
    /// Index of the avatar that each place belongs to; None before its first.
    owners: Vec<Option<usize>>,
}

/// A place of the pose buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PosePlace {
    /// Its number.
    pub number: usize,
    /// Whether it held another avatar's data, or nothing: all networks have to run.
    pub is_new: bool,
}

impl PosePlaces {
    /// Gives each of these avatars, at most `count`, one of `count` places: the one that it has,
    /// else one of an avatar that is not among them.
    pub fn assign(&mut self, avatars: &[usize], count: usize) -> Vec<PosePlace> {
        self.owners.resize(count, None);
        let kept: Vec<Option<usize>> = avatars
            .iter()
            .map(|avatar| self.owners.iter().position(|own| *own == Some(*avatar)))
            .collect();
        let mut is_kept = vec![false; count];
        for &number in kept.iter().flatten() {
            is_kept[number] = true;
        }
        let mut free = (0..count).filter(|&number| !is_kept[number]);
        let mut assigned = Vec::with_capacity(avatars.len());
        for (&avatar, kept) in avatars.iter().zip(&kept) {
            // Avatars that were never there before take the free places in order.
            let Some(number) = kept.or_else(|| free.next()) else {
                break;
            };
            assigned.push(PosePlace {
                number,
                is_new: kept.is_none(),
            });
            self.owners[number] = Some(avatar);
        }
        assigned
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demo::{self, with_levels};

    fn options(instances: usize, gaussians: Option<u32>) -> RendererOptions {
        RendererOptions {
            instances,
            gaussians,
            ..RendererOptions::new([64, 64])
        }
    }

    #[test]
    fn all_avatars_fit_unless_less_is_asked_for() {
        let avatar = demo::avatar().expect("inside the program");
        let bounds = AvatarBounds::new(&avatar);
        let count = avatar.gaussians.len() as u32;
        let capacity =
            |instances, gaussians| Capacity::new(&options(instances, gaussians), &bounds);
        let all = capacity(5, None).expect("a capacity");
        assert_eq!((all.gaussians, all.posed), (5 * count, 5));
        // A crowd has what four avatars have, or the coarsest of each.
        let crowd = capacity(24, None).expect("a capacity");
        assert_eq!((crowd.gaussians, crowd.posed), (4 * count, 24));
        assert_eq!(capacity(64, None).expect("a capacity").gaussians, 8 * count);
        let some = capacity(32, Some(4 * count)).expect("a capacity");
        assert_eq!((some.gaussians, some.posed), (4 * count, 32));
        let error = capacity(64, Some(count)).expect_err("too little");
        assert!(error.to_string().contains(&count.to_string()), "{error}");
        assert!(capacity(1, Some(count - 10)).is_err());
    }

    #[test]
    fn the_densest_are_drawn_coarser() {
        let bounds = AvatarBounds::new(&with_levels());
        let count = bounds.gaussians() as u32;
        let capacity = Capacity::new(&options(8, Some(2 * count)), &bounds).expect("a capacity");
        let mut portions = [Portion { model: 0, level: 0 }; 8];
        let sides = [900.0, 100.0, 90.0, 80.0, 70.0, 60.0, 50.0, 40.0];
        capacity.fit(&mut portions, |avatar| sides[avatar], &[&bounds; 8]);
        let total: u32 = portions.iter().map(|own| own.gaussians(&bounds)).sum();
        assert!(total <= 2 * count && total > count, "{portions:?}");
        assert_eq!(portions[0], Portion { model: 0, level: 0 });
        assert!(portions.is_sorted_by_key(|own| own.model));
        // What fits stays.
        let before = portions;
        capacity.fit(&mut portions, |avatar| sides[avatar], &[&bounds; 8]);
        assert_eq!(portions, before);
    }

    #[test]
    fn there_is_always_a_portion_that_fits() {
        let bounds = AvatarBounds::new(&with_levels());
        let count = bounds.gaussians() as u32;
        let coarsest = Portion::coarsest(&bounds).gaussians(&bounds);
        let instances = (count / coarsest) as usize;
        let capacity =
            Capacity::new(&options(instances, Some(count)), &bounds).expect("a capacity");
        let mut portions = vec![Portion { model: 0, level: 0 }; instances];
        for side in [1000.0, 0.0, f64::INFINITY, f64::NAN] {
            capacity.fit(&mut portions, |_| side, &vec![&bounds; instances]);
            let drawn = portions.iter().map(|own| own.gaussians(&bounds));
            assert!(drawn.sum::<u32>() <= capacity.gaussians);
        }
    }

    #[test]
    fn avatars_keep_their_places() {
        let mut places = PosePlaces::default();
        let mut assign = |avatars: &[usize]| -> Vec<(usize, bool)> {
            let places = places.assign(avatars, 3);
            places.iter().map(|own| (own.number, own.is_new)).collect()
        };
        assert_eq!(assign(&[7, 9]), [(0, true), (1, true)]);
        assert_eq!(assign(&[9, 4, 7]), [(1, false), (2, true), (0, false)]);
        assert_eq!(assign(&[5, 4]), [(0, true), (2, false)]);
        // The places of those that are away are kept until they are needed.
        assert_eq!(assign(&[9]), [(1, false)]);
        assert_eq!(assign(&[1, 2, 3]), [(0, true), (1, true), (2, true)]);
    }
}
