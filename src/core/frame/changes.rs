//! Which stages an avatar needs, from what changed since its last frame.

use super::{Skip, atlas::AtlasSlot, capacity::Portion};
use crate::scene::{Camera, PartDependencies, PartSet, Posed};
use glam::DAffine3;

/// Where the project stage gets skinned Gaussians from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skinning {
    /// Computed from the model.
    Compute,
    /// Computed from the model and stored in the pose cache.
    ComputeAndStore,
    /// Read from the pose cache.
    Cached,
}

/// What has changed about an avatar since its last frame, and so which stages it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AvatarChanges {
    /// Mlp and nodes run: the networks' input has changed.
    pub pose: bool,
    /// Of the networks' input only the expression has changed, which only the head's networks see.
    pub expression_only: bool,
    /// Project, sort and raster run: something in the image has changed.
    pub redraw: bool,
    /// Where skinned Gaussians come from.
    pub skinning: Skinning,
}

/// How a frame draws an avatar, apart from its pose.
#[derive(Clone, Copy, Debug)]
pub struct AvatarView {
    /// The camera of the image that it is drawn into.
    pub camera: Camera,
    /// The portion of it that is drawn.
    pub portion: Portion,
    /// The coarsest of its levels by which nothing is lost.
    pub near: usize,
    /// Its slot of the atlas, if it is drawn larger than it is shown.
    pub slot: Option<AtlasSlot>,
    /// Where its pose cache starts among those of all avatars, Gaussians.
    pub cache_start: u32,
}

/// An avatar as the last image shows it.
#[derive(Clone, Debug)]
struct DrawnState {
    joints: Vec<DAffine3>,
    view: AvatarView,
}

/// Remembers what the last frame showed of an avatar.
#[derive(Clone, Debug)]
pub struct ChangeTracker {
    /// Input of the networks; None before the first frame.
    input: Option<Vec<f64>>,
    /// None before the first frame.
    shown: Option<DrawnState>,
    /// Where the pose cache holds what the last frame showed, if it does.
    cached: Option<u32>,
    /// Parts whose networks have not run since their input changed.
    stale: PartSet,
}

impl Default for ChangeTracker {
    fn default() -> Self {
        Self {
            input: None,
            shown: None,
            cached: None,
            stale: PartSet::ALL,
        }
    }
}

impl ChangeTracker {
    /// The level of detail that the last frame showed; 0 before the first.
    pub fn level(&self) -> u32 {
        self.shown.as_ref().map_or(0, |own| own.view.portion.level)
    }

    /// Which of the avatar's levels was near enough in the last frame; 0 is the avatar itself.
    pub fn near(&self) -> usize {
        self.shown.as_ref().map_or(0, |own| own.view.near)
    }

    /// Returns the work of the next frame, without what `skip` lets it leave out, and remembers the
    /// frame as the last one.
    pub fn update(&mut self, posed: &Posed, view: &AvatarView, skip: Skip) -> AvatarChanges {
        let input_changed = self.input.as_ref() != Some(&posed.input);
        let pose = input_changed || !skip.contains(Skip::POSE);
        let expression_only = pose && skip.contains(Skip::EXPRESSION) && self.same_body(posed);

        // Everything except the camera, then the camera too.
        let mut same_gaussians = false;
        let mut same_camera = false;
        if let Some(shown) = &self.shown {
            same_gaussians = !input_changed
                && shown.joints == posed.joints
                && shown.view.portion == view.portion;
            // A slot that moves in the image may hold the same.
            same_camera = shown.view.camera == view.camera && shown.view.slot == view.slot;
        }
        let redraw = pose || !skip.contains(Skip::FRAME) || !(same_gaussians && same_camera);
        let skinning = if !same_gaussians || !skip.contains(Skip::SKINNING) {
            Skinning::Compute
        } else if self.cached == Some(view.cache_start) {
            Skinning::Cached
        } else {
            Skinning::ComputeAndStore
        };

        if pose {
            self.input = Some(posed.input.clone());
        }
        if redraw {
            self.shown = Some(DrawnState {
                joints: posed.joints.clone(),
                view: *view,
            });
            self.note_cache(skinning, view.cache_start);
        }
        AvatarChanges {
            pose,
            expression_only,
            redraw,
            skinning,
        }
    }

    /// Whether the networks' input has the same numbers as in the last frame before the
    /// expression.
    fn same_body(&self, posed: &Posed) -> bool {
        let body = |input: &[f64]| input[..input.len().saturating_sub(posed.expression)].to_vec();
        self.input.as_ref().is_some_and(|before| {
            before.len() == posed.input.len() && body(before) == body(&posed.input)
        })
    }

    /// Its networks' outputs are gone: all of them are due.
    pub fn lose_networks(&mut self) {
        self.stale = PartSet::ALL;
    }

    /// Remembers that the frame was drawn with these changes although this avatar alone did not
    /// need it.
    pub fn mark_drawn(&mut self, changes: &AvatarChanges, cache_start: u32) {
        self.note_cache(changes.skinning, cache_start);
    }

    /// Remembers that a frame was drawn without it, whose avatars may have used its pose cache.
    pub fn mark_absent(&mut self) {
        self.cached = None;
    }

    fn note_cache(&mut self, skinning: Skinning, start: u32) {
        self.cached = (skinning != Skinning::Compute).then_some(start);
    }

    /// The parts whose networks run in a frame: those whose input has changed since they ran and
    /// that something in `visible` depends on. The others wait until they come into view. A frame
    /// that fills the pose cache runs all that is due, and so does one where `visible` is None.
    /// None run where they move nothing that is drawn: `correctives` is false.
    pub fn schedule_networks(
        &mut self,
        changes: &AvatarChanges,
        dependencies: &PartDependencies,
        visible: Option<&PartSet>,
        correctives: bool,
    ) -> PartSet {
        if changes.expression_only {
            self.stale = self.stale | dependencies.head;
        } else if changes.pose {
            self.stale = dependencies.all();
        }
        let needed = match visible {
            _ if !correctives => PartSet::EMPTY,
            None => dependencies.all(),
            Some(visible) if changes.skinning == Skinning::Compute => {
                dependencies.networks(visible)
            }
            Some(_) => dependencies.networks(&PartSet::ALL),
        };
        let run = self.stale & needed;
        self.stale = self.stale - run;
        run
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A change of the image alone.
    fn redrawn(skinning: Skinning) -> AvatarChanges {
        AvatarChanges {
            pose: false,
            expression_only: false,
            redraw: true,
            skinning,
        }
    }

    fn posed_again(skinning: Skinning) -> AvatarChanges {
        AvatarChanges {
            pose: true,
            ..redrawn(skinning)
        }
    }

    fn unchanged(skinning: Skinning) -> AvatarChanges {
        AvatarChanges {
            redraw: false,
            ..redrawn(skinning)
        }
    }

    fn camera(yaw: f64) -> Camera {
        Camera::orbit(DVec3::ZERO, yaw, 0.0, 2.0, 0.7, [64, 64])
    }

    fn view(yaw: f64, level: u32) -> AvatarView {
        AvatarView {
            camera: camera(yaw),
            portion: Portion { model: 0, level },
            near: 0,
            slot: None,
            cache_start: 0,
        }
    }

    fn pose(input: &[f64], expression: usize) -> Posed {
        Posed {
            joints: vec![DAffine3::IDENTITY],
            input: input.to_vec(),
            expression,
        }
    }

    #[test]
    fn a_moving_camera_fills_and_reads_the_pose_cache() {
        let posed = pose(&[0.0], 0);
        let mut tracker = ChangeTracker::default();
        let mut update = |yaw, level| tracker.update(&posed, &view(yaw, level), Skip::all());
        assert_eq!(update(0.0, 0), posed_again(Skinning::Compute));
        assert_eq!(update(0.0, 0), unchanged(Skinning::ComputeAndStore));
        assert_eq!(update(0.1, 0), redrawn(Skinning::ComputeAndStore));
        assert_eq!(update(0.2, 0), redrawn(Skinning::Cached));
        // The cache of another level of detail holds other Gaussians.
        assert_eq!(update(0.2, 1), redrawn(Skinning::Compute));
        assert_eq!(update(0.2, 1), unchanged(Skinning::ComputeAndStore));
    }

    #[test]
    fn only_what_changed_runs_again() {
        let mut posed = pose(&[0.0], 0);
        let mut tracker = ChangeTracker::default();
        let mut update = |posed: &Posed, skip| tracker.update(posed, &view(0.1, 0), skip);
        update(&posed, Skip::all());
        posed.joints[0] = DAffine3::from_translation(DVec3::X);
        assert_eq!(update(&posed, Skip::all()), redrawn(Skinning::Compute));
        posed.input[0] = 1.0;
        assert_eq!(update(&posed, Skip::all()), posed_again(Skinning::Compute));
        assert_eq!(
            update(&posed, Skip::empty()),
            posed_again(Skinning::Compute)
        );
        assert_eq!(update(&posed, Skip::POSE), redrawn(Skinning::Compute));
        assert_eq!(
            update(&posed, Skip::all()),
            unchanged(Skinning::ComputeAndStore)
        );
    }

    #[test]
    fn a_new_expression_runs_only_the_head() {
        let mut tracker = ChangeTracker::default();
        // The last number is the expression's.
        let mut update = |input: &[f64], skip| tracker.update(&pose(input, 1), &view(0.1, 0), skip);
        assert!(!update(&[1.0, 2.0], Skip::all()).expression_only);
        assert_eq!(
            update(&[1.0, 3.0], Skip::all()),
            AvatarChanges {
                expression_only: true,
                ..posed_again(Skinning::Compute)
            }
        );
        assert!(!update(&[1.0, 4.0], Skip::all() - Skip::EXPRESSION).expression_only);
        assert!(!update(&[5.0, 6.0], Skip::all()).expression_only);
    }

    #[test]
    fn networks_wait_until_they_are_visible() {
        let avatar = crate::demo::avatar().unwrap();
        let dependencies = PartDependencies::new(&avatar);
        let all = dependencies.all();
        let one = PartSet::first(1);
        let mut tracker = ChangeTracker::default();
        let mut schedule = |changes: AvatarChanges, visible: Option<&PartSet>| {
            tracker.schedule_networks(&changes, &dependencies, visible, true)
        };
        let new_pose = posed_again(Skinning::Compute);
        let new_expression = AvatarChanges {
            expression_only: true,
            ..new_pose
        };
        let same_pose = redrawn(Skinning::Compute);
        let fill_cache = redrawn(Skinning::ComputeAndStore);
        let needed = dependencies.networks(&one);
        assert_eq!(schedule(new_pose, Some(&one)), needed);
        assert!(schedule(same_pose, Some(&one)).is_empty());
        assert_eq!(schedule(same_pose, Some(&all)), all - needed);
        assert!(schedule(fill_cache, Some(&one)).is_empty());
        assert_eq!(schedule(new_expression, Some(&all)), dependencies.head);
        // The expression changes while some of the body waits.
        schedule(new_pose, Some(&one));
        assert_eq!(
            schedule(new_expression, Some(&all)),
            dependencies.head | (all - needed)
        );
        schedule(new_pose, Some(&one));
        assert_eq!(schedule(fill_cache, Some(&one)), all - needed);
        assert_eq!(schedule(new_pose, None), all);
    }
}
