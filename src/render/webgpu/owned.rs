//! Memory of a device that is given back when its owner is dropped. In browsers dropping alone
//! gives nothing back: the page would hold every avatar that it ever showed until its collector
//! runs, which knows nothing of the device's memory.

use std::ops::Deref;

/// An object that holds memory of a device.
pub trait Destroy {
    /// Gives its memory back once submitted work is done with it. Later work must not use it.
    fn destroy(&self);
}

macro_rules! resource {
    ($($type:ident)*) => {
        $(impl Destroy for wgpu::$type {
            fn destroy(&self) {
                wgpu::$type::destroy(self);
            }
        })*
    };
}

resource!(Buffer Texture QuerySet);

/// The one owner of something: frames that were submitted still find it, later ones don't.
pub struct Owned<T: Destroy>(pub T);

/// A [`wgpu::Buffer`], destroyed when it is dropped.
pub type Buffer = Owned<wgpu::Buffer>;
/// A [`wgpu::Texture`], destroyed when it is dropped.
pub type OwnedTexture = Owned<wgpu::Texture>;
/// A [`wgpu::QuerySet`], destroyed when it is dropped.
pub type QuerySet = Owned<wgpu::QuerySet>;

impl<T: Destroy> Deref for Owned<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T: Destroy> Drop for Owned<T> {
    fn drop(&mut self) {
        self.0.destroy();
    }
}
