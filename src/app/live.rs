//! An avatar that changes while it is shown: whoever makes it, such as a training, hands over newer
//! ones from another thread.

use crate::message::Message;
use effigy_core::avatar::Avatar;
use std::sync::{Arc, Weak};
use winit::event_loop::EventLoopProxy;

/// The way from whoever makes an avatar to the window that shows it. The window closes when this is
/// dropped.
pub struct LiveAvatar {
    proxy: EventLoopProxy<Message>,
    /// Alive until the window has taken the last avatar.
    on_its_way: Weak<()>,
    closed: bool,
}

impl LiveAvatar {
    pub(crate) fn new(proxy: EventLoopProxy<Message>) -> Self {
        Self {
            proxy,
            on_its_way: Weak::new(),
            closed: false,
        }
    }

    /// Whether the window would show another avatar now: it is open and has taken the last one, so
    /// that avatars don't pile up before a window that is slow.
    pub fn is_ready(&self) -> bool {
        !self.closed && self.on_its_way.strong_count() == 0
    }

    /// Shows an avatar in place of the last one. The view, the clips and the place in them stay.
    /// Without a window any more, nothing happens.
    pub fn show(&mut self, avatar: Avatar) {
        let until_taken = Arc::new(());
        self.on_its_way = Arc::downgrade(&until_taken);
        let newer = Message::Newer {
            avatar: Arc::new(avatar),
            until_taken,
        };
        self.closed = self.proxy.send_event(newer).is_err();
    }
}

impl Drop for LiveAvatar {
    fn drop(&mut self) {
        // If the window is closed already, no one is left to receive it.
        let _ = self.proxy.send_event(Message::Close);
    }
}
