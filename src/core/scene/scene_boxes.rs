//! What a scene's splats show, and where nearly all of them are.

use super::AxisBox;
use crate::avatar::Avatar;
use glam::{DMat3, DQuat, DVec3};

/// Splats that are looked at, at most: a share of half a hundredth of these is known to a tenth.
const SAMPLES: usize = 20_000;
/// Deviations from its centre to where a splat is taken to end.
const DEVIATIONS: f64 = 2.0;
/// Share of the weight that is left out at each end of an axis.
const TRIMMED: f64 = 0.005;
/// Distances from the middle, of the median one: beyond the first splats are left out where they
/// are [`FEW`], beyond the second always, as a sky is.
const FAR: [f64; 2] = [5.0, 30.0];
/// Share of the weight that far splats are left out for.
const FEW: f64 = 0.1;

/// Where a scene is, in canonical space, whatever a few far splats do.
#[derive(Clone, Copy, Debug)]
pub struct SceneBoxes {
    /// Around what shows.
    pub shown: AxisBox,
    /// Around where nearly all splats are: keys and caches are exact there, and coarser beyond.
    pub dense: AxisBox,
}

/// A splat, as far as framing looks at it.
struct Spot {
    center: DVec3,
    /// From the centre to where it ends along each axis.
    half: DVec3,
    /// What it shows: opacity times area, of which no more than the median counts.
    weight: f64,
}

impl SceneBoxes {
    /// Of an avatar that nothing moves inside. `all`: a box around its Gaussians' centres.
    pub fn new(avatar: &Avatar, all: AxisBox) -> Self {
        let spots = spots(avatar);
        if spots.is_empty() {
            return Self {
                shown: all,
                dense: all,
            };
        }
        let dense = between(&spots, TRIMMED, |_| 1.0, |_| DVec3::ZERO);
        let side = dense.max - dense.min;
        Self {
            shown: shown(&spots),
            dense: AxisBox {
                min: (dense.min - side).max(all.min),
                max: (dense.max + side).min(all.max),
            },
        }
    }
}

/// Some of an avatar's splats, evenly spread over it.
fn spots(avatar: &Avatar) -> Vec<Spot> {
    let gaussians = &avatar.gaussians;
    let every = gaussians.len().div_ceil(SAMPLES).max(1);
    let mut spots: Vec<Spot> = (0..gaussians.len())
        .step_by(every)
        .map(|k| {
            let [w, x, y, z] = gaussians.rotation[k].map(f64::from);
            let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
            let scale = DVec3::from(gaussians.log_scale[k].map(f64::from)).exp();
            let axes = rotation * DMat3::from_diagonal(scale);
            let area = scale.dot(DVec3::new(scale.y, scale.z, scale.x));
            Spot {
                center: avatar.placed(k),
                half: DEVIATIONS * DVec3::from([0, 1, 2].map(|axis| axes.row(axis).length())),
                weight: area,
            }
        })
        .collect();
    // One that covers all would decide alone, and so would a sky.
    let most = quantile(&spots, 0.5, |_| 1.0, |spot| spot.weight);
    for (spot, k) in spots.iter_mut().zip((0..).step_by(every)) {
        spot.weight = spot.weight.min(most) * f64::from(gaussians.opacity[k]);
    }
    if spots.iter().all(|spot| spot.weight == 0.0) {
        spots.iter_mut().for_each(|spot| spot.weight = 1.0);
    }
    spots
}

/// A box around what splats show, without a few far ones.
fn shown(spots: &[Spot]) -> AxisBox {
    let weight = |spot: &Spot| spot.weight;
    let middle =
        DVec3::from([0, 1, 2].map(|axis| quantile(spots, 0.5, weight, |spot| spot.center[axis])));
    let distance = |spot: &Spot| spot.center.distance(middle);
    let median = quantile(spots, 0.5, weight, |spot| {
        distance(spot) + spot.half.max_element()
    });
    let within = |far: f64| {
        move |spot: &Spot| {
            if distance(spot) <= far * median {
                spot.weight
            } else {
                0.0
            }
        }
    };
    let total: f64 = spots.iter().map(weight).sum();
    let near: f64 = spots.iter().map(within(FAR[0])).sum();
    let far = if near >= (1.0 - FEW) * total {
        FAR[0]
    } else {
        FAR[1]
    };
    between(spots, TRIMMED, within(far), |spot| spot.half)
}

/// A box that splats of the weight end in, but for a share of it at each end of each axis.
fn between(
    spots: &[Spot],
    share: f64,
    weight: impl Fn(&Spot) -> f64,
    half: impl Fn(&Spot) -> DVec3,
) -> AxisBox {
    let end = |sign: f64| {
        DVec3::from([0, 1, 2].map(|axis| {
            quantile(spots, share, &weight, |spot| {
                (sign * spot.center - half(spot))[axis]
            })
        }))
    };
    let [low, high] = [end(1.0), -end(-1.0)];
    AxisBox {
        min: low.min(high),
        max: low.max(high),
    }
}

/// The number up to which a share of the weight lies. There is a spot.
fn quantile(
    spots: &[Spot],
    share: f64,
    weight: impl Fn(&Spot) -> f64,
    number: impl Fn(&Spot) -> f64,
) -> f64 {
    let mut order: Vec<&Spot> = spots.iter().filter(|spot| weight(spot) > 0.0).collect();
    order.sort_unstable_by(|a, b| number(a).total_cmp(&number(b)));
    let all: f64 = order.iter().map(|spot| weight(spot)).sum();
    // Equal weights sum to the share itself in every unit.
    let mut left = (share - 1e-9) * all;
    let at = order.iter().position(|spot| {
        left -= weight(spot);
        left <= 0.0
    });
    at.or(order.len().checked_sub(1))
        .map_or(0.0, |at| number(order[at]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        avatar::{Filter, Pose},
        constants::NEAR,
        io::splats::{Splats, Up},
        random::Random,
        scene::{AvatarBounds, Framing},
    };

    /// A round splat.
    #[derive(Clone, Copy)]
    struct Ball {
        center: DVec3,
        deviation: f64,
        opacity: f64,
    }

    fn ball(center: DVec3, deviation: f64, opacity: f64) -> Ball {
        Ball {
            center,
            deviation,
            opacity,
        }
    }

    /// What cameras frame of round splats, and the box of their dense part.
    fn framed(balls: &[Ball]) -> (Framing, [DVec3; 2]) {
        let splats = Splats {
            position: balls
                .iter()
                .map(|ball| ball.center.as_vec3().to_array())
                .collect(),
            rotation: vec![[1.0, 0.0, 0.0, 0.0]; balls.len()],
            log_scale: balls
                .iter()
                .map(|ball| [ball.deviation.ln() as f32; 3])
                .collect(),
            opacity: balls
                .iter()
                .map(|ball| (ball.opacity / (1.0 - ball.opacity)).ln() as f32)
                .collect(),
            color: vec![[0.5; 3]; balls.len()],
            degree: 0,
            harmonics: vec![],
            up: Up::Y,
            filter: Filter::DEFAULT,
        };
        let avatar = splats.to_avatar("balls").expect("splats that fit");
        let joints = avatar.skeleton.matrices(&Pose::rest(1, 0));
        let bounds = AvatarBounds::new(&avatar);
        (bounds.framing(&joints), bounds.dense(&joints))
    }

    /// So many opaque splats within a ball.
    fn subject(count: usize, middle: DVec3, radius: f64) -> Vec<Ball> {
        let random = &mut Random::new(3, count as u64);
        let mut place = || middle + radius * random.uniform().cbrt() * random.direction();
        (0..count)
            .map(|_| ball(place(), 0.016 * radius, 0.9))
            .collect()
    }

    fn size(framing: &Framing) -> f64 {
        framing.bounds[0].distance(framing.bounds[1])
    }

    #[test]
    fn a_scene_is_framed_alike_in_every_unit() {
        let one = framed(&subject(900, DVec3::new(0.1, 0.2, -0.3), 0.5)).0;
        for scale in [1e3, 100.0, 0.1, 0.01, 1e-3] {
            let other = framed(&subject(
                900,
                scale * DVec3::new(0.1, 0.2, -0.3),
                0.5 * scale,
            ))
            .0;
            for (a, b) in one.bounds.iter().zip(other.bounds) {
                assert!(
                    (*a - b / scale).abs().max_element() < 2e-3,
                    "{scale}: {a} {b}"
                );
            }
            let near = (one.near * scale).min(NEAR);
            assert!(
                (other.near / near - 1.0).abs() < 0.01,
                "{scale}: {}",
                other.near
            );
        }
    }

    #[test]
    fn a_few_far_splats_change_neither_view_nor_precision() {
        let middle = DVec3::new(0.0, 10.0, 1000.0);
        let own = subject(4000, middle, 0.5);
        let alone = framed(&own);
        let random = &mut Random::new(5, 0);
        let mut around = |opacity, deviation| -> Vec<Ball> {
            let mut far = || middle + random.range(200.0, 600.0) * random.direction();
            (0..12).map(|_| ball(far(), deviation, opacity)).collect()
        };
        let one_side: Vec<Ball> = (0..12)
            .map(|k| {
                ball(
                    middle + DVec3::new(300.0 + f64::from(k), 5.0, 2.0),
                    0.5,
                    0.1,
                )
            })
            .collect();
        for far in [
            around(0.05, 0.5),
            around(0.95, 0.01),
            around(0.98, 5.0),
            one_side,
        ] {
            let (framing, dense) = framed(&[own.clone(), far].concat());
            assert!(framing.middle().distance(alone.0.middle()) < 0.05);
            assert!((size(&framing) / size(&alone.0) - 1.0).abs() < 0.1);
            assert!(dense[0].distance(dense[1]) < 6.0);
        }
    }

    #[test]
    fn two_subjects_are_both_framed_and_a_sky_is_not() {
        let [left, right] = [-10.0, 10.0].map(|x| subject(500, DVec3::new(x, 0.0, 0.0), 1.0));
        let (framing, _) = framed(&[left, right].concat());
        assert!(framing.bounds[0].x < -10.5 && framing.bounds[1].x > 10.5);
        let room = subject(2000, DVec3::Y, 5.0);
        let random = &mut Random::new(2, 0);
        let sky = (0..1000)
            .map(|_| ball(1000.0 * random.direction(), 20.0, 0.9))
            .collect();
        let (framing, dense) = framed(&[room, sky].concat());
        assert!(size(&framing) < 25.0, "{framing:?}");
        assert!(
            dense[0].distance(dense[1]) > 3000.0,
            "there are too many to be coarse"
        );
    }

    #[test]
    fn the_smallest_scenes_have_a_size() {
        let one = ball(DVec3::new(1.0, 2.0, 3.0), 0.2, 0.9);
        for balls in [vec![one], vec![one; 2]] {
            let (framing, _) = framed(&balls);
            assert!((framing.middle() - one.center).length() < 1e-6);
            assert!((framing.bounds[1].x - 1.4).abs() < 1e-3);
        }
        let sheet: Vec<Ball> = (0..400)
            .map(|k| {
                ball(
                    DVec3::new(f64::from(k % 20), f64::from(k / 20), 0.0),
                    0.5,
                    0.9,
                )
            })
            .collect();
        let (framing, _) = framed(&sheet);
        assert!((size(&framing) - (20f64 * 20.0 * 2.0 + 4.0).sqrt()).abs() < 2.0);
        let clear = framed(&[ball(DVec3::ZERO, 0.1, 1e-6)]).0;
        assert!(
            size(&clear) > 0.5,
            "splats that show nothing are framed by their places"
        );
        let point = framed(&[ball(DVec3::X, 1e-12, 0.9)]).0;
        assert!(point.near == 1e-6 && size(&point) > 0.0);
    }

    #[test]
    fn a_person_has_one_scale_in_every_pose() {
        let avatar = crate::demo::avatar().expect("inside the program");
        let joints = avatar
            .skeleton
            .matrices(&Pose::rest(avatar.skeleton.len(), 0));
        let bounds = AvatarBounds::new(&avatar);
        let framing = bounds.framing(&joints);
        let [min, max] = bounds.bounds(&joints);
        let half = ((max - min) / 2.0).max(DVec3::new(0.4, 0.92, 0.4));
        let middle = (min + max) / 2.0;
        assert_eq!(framing.bounds, [middle - half, middle + half]);
        assert_eq!((framing.near, bounds.dense(&joints)), (NEAR, [min, max]));
    }
}
