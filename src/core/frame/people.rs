//! The people of a frame: the avatars that a renderer holds, and who of them stands where.

use super::Unusable;
use crate::{
    avatar::Avatar,
    scene::{AvatarBounds, PartDependencies, Posed},
};

/// An avatar that a renderer holds. It stays the same for as long as the renderer holds that
/// avatar, and is never another's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AvatarId {
    slot: u32,
    generation: u32,
}

impl AvatarId {
    /// The avatar that a renderer was made with.
    pub const FIRST: Self = Self {
        slot: 0,
        generation: 0,
    };
}

/// A person of a frame: an avatar in a pose. Several may be of one avatar.
#[derive(Clone, Copy, Debug)]
pub struct Person<'a> {
    /// Whose looks.
    pub avatar: AvatarId,
    /// The evaluated pose, of that avatar.
    pub posed: &'a Posed,
}

impl<'a> From<&'a Posed> for Person<'a> {
    /// A person of [`AvatarId::FIRST`].
    fn from(posed: &'a Posed) -> Self {
        Self {
            avatar: AvatarId::FIRST,
            posed,
        }
    }
}

impl<'a> Person<'a> {
    /// People of [`AvatarId::FIRST`], one a pose.
    pub fn copies(poses: &[&'a Posed]) -> Vec<Self> {
        poses.iter().map(|&posed| posed.into()).collect()
    }
}

/// What plans need to know of an avatar.
#[derive(Clone, Debug)]
pub struct AvatarTraits {
    /// Its bounds.
    pub bounds: AvatarBounds,
    /// Which parts' networks each part depends on.
    pub dependencies: PartDependencies,
    /// Whether its colours come from spherical harmonics.
    pub has_sh: bool,
}

impl AvatarTraits {
    /// Those of an avatar with these bounds.
    pub fn new(avatar: &Avatar, bounds: AvatarBounds) -> Self {
        Self {
            bounds,
            dependencies: PartDependencies::new(avatar),
            has_sh: avatar.sh.is_some(),
        }
    }
}

/// A person of a frame, with what plans need to know.
#[derive(Clone, Copy)]
pub struct PlannedPerson<'a, 'pose> {
    /// Whose looks.
    pub avatar: AvatarId,
    /// What is known of that avatar.
    pub traits: &'a AvatarTraits,
    /// The evaluated pose.
    pub posed: &'pose Posed,
}

/// People with what a renderer knows of the avatars that it holds.
///
/// # Errors
/// When an avatar is not held (any more).
pub fn planned<'a, 'pose>(
    people: &[Person<'pose>],
    traits: impl Fn(AvatarId) -> Option<&'a AvatarTraits>,
) -> Result<Vec<PlannedPerson<'a, 'pose>>, Unusable> {
    let planned = people.iter().enumerate().map(|(at, person)| {
        let Person { avatar, posed } = *person;
        match traits(avatar) {
            Some(traits) => Ok(PlannedPerson {
                avatar,
                traits,
                posed,
            }),
            None => Err(Unusable {
                what: "the avatar of a person".into(),
                found: format!("person {at} of an avatar that was removed"),
                expected: "one that the renderer holds".into(),
            }),
        }
    });
    planned.collect()
}

/// A value for each avatar that a renderer holds.
#[derive(Debug)]
pub struct ByAvatar<T> {
    slots: Vec<Slot<T>>,
}

#[derive(Debug)]
struct Slot<T> {
    /// Of the value, or of the next one if there is none.
    generation: u32,
    value: Option<T>,
}

impl<T> ByAvatar<T> {
    /// With a value for [`AvatarId::FIRST`].
    pub fn new(first: T) -> Self {
        let slot = Slot {
            generation: 0,
            value: Some(first),
        };
        Self { slots: vec![slot] }
    }

    /// Adds a value.
    pub fn insert(&mut self, value: T) -> AvatarId {
        let free = self.slots.iter().position(|slot| slot.value.is_none());
        let slot = free.unwrap_or_else(|| {
            self.slots.push(Slot {
                generation: 0,
                value: None,
            });
            self.slots.len() - 1
        });
        self.slots[slot].value = Some(value);
        AvatarId {
            slot: slot as u32,
            generation: self.slots[slot].generation,
        }
    }

    /// Takes a value out. None if there is none for this avatar (any more).
    pub fn remove(&mut self, id: AvatarId) -> Option<T> {
        let slot = self.slots.get_mut(id.slot as usize)?;
        let held = slot.value.take_if(|_| slot.generation == id.generation)?;
        slot.generation += 1;
        Some(held)
    }

    /// The value of an avatar. None if there is none (any more).
    pub fn get(&self, id: AvatarId) -> Option<&T> {
        let slot = self.slots.get(id.slot as usize)?;
        let value = slot.value.as_ref()?;
        (slot.generation == id.generation).then_some(value)
    }

    /// [`Self::get`] to change it.
    pub fn get_mut(&mut self, id: AvatarId) -> Option<&mut T> {
        let slot = self.slots.get_mut(id.slot as usize)?;
        let value = slot.value.as_mut()?;
        (slot.generation == id.generation).then_some(value)
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = &T> + Clone {
        self.slots.iter().filter_map(|slot| slot.value.as_ref())
    }

    /// All values, to change them.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.slots.iter_mut().filter_map(|slot| slot.value.as_mut())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_is_never_another_avatars() {
        let mut held = ByAvatar::new("first");
        let second = held.insert("second");
        assert_eq!(held.get(AvatarId::FIRST), Some(&"first"));
        assert_eq!(held.remove(AvatarId::FIRST), Some("first"));
        assert_eq!(held.remove(AvatarId::FIRST), None);
        let third = held.insert("third");
        assert_eq!(held.get(AvatarId::FIRST), None);
        assert_eq!(held.get_mut(second), Some(&mut "second"));
        assert_eq!(held.get(third), Some(&"third"));
        assert_eq!(held.values().collect::<Vec<_>>(), [&"third", &"second"]);
    }
}
