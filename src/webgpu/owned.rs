//! Memory of a device that is given back when its owner is dropped. In browsers dropping alone
//! gives nothing back: the page would hold every avatar that it ever showed until its collector
//! runs, which knows nothing of the device's memory.

use std::ops::Deref;

/// What a device has memory for.
pub trait Destroy {
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

pub type Buffer = Owned<wgpu::Buffer>;
pub type Texture = Owned<wgpu::Texture>;
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
