//! A program that a user drags files from: the source's side of X11's drag and drop, version 5.

use super::session::atom;
use std::time::{Duration, Instant};
use x11rb::{
    connection::Connection,
    protocol::{
        Event,
        xproto::{
            self, ClientMessageEvent, ConnectionExt as _, EventMask, PropMode,
            SELECTION_NOTIFY_EVENT, SelectionNotifyEvent, Window,
        },
    },
    rust_connection::RustConnection,
    wrapper::ConnectionExt as _,
};

/// The version of the protocol, in the first byte of a word.
const VERSION: u32 = 5 << 24;
/// No answer takes longer.
const LIMIT: Duration = Duration::from_secs(60);

/// A window that files are dragged from.
pub struct DragSource<'a> {
    x: &'a RustConnection,
    window: Window,
    target: Window,
    /// The type of a list of files.
    uri_list: u32,
    selection: u32,
}

impl<'a> DragSource<'a> {
    /// Opens a window beside the one that files are dragged to.
    pub fn new(x: &'a RustConnection, root: Window, target: Window) -> Self {
        let window = x.generate_id().unwrap();
        let class = xproto::WindowClass::INPUT_ONLY;
        let values = Default::default();
        x.create_window(0, window, root, 0, 0, 1, 1, 0, class, 0, &values)
            .unwrap();
        Self {
            x,
            window,
            target,
            uri_list: atom(x, "text/uri-list"),
            selection: atom(x, "XdndSelection"),
        }
    }

    /// Drops files on the target, and waits until it has taken them. `list`: an address a line.
    pub fn drop_list(&self, list: &str) {
        let now = x11rb::CURRENT_TIME;
        self.x
            .set_selection_owner(self.window, self.selection, now)
            .unwrap();
        self.send("XdndEnter", [VERSION, self.uri_list, 0, 0]);
        let copy = atom(self.x, "XdndActionCopy");
        let position = 40 << 16 | 40;
        self.send("XdndPosition", [0, position, now, copy]);
        let status = self.wait_for("XdndStatus", list);
        assert!(status[1] & 1 == 1, "the window takes no files");
        self.send("XdndDrop", [0, now, 0, 0]);
        let finished = self.wait_for("XdndFinished", list);
        assert!(finished[1] & 1 == 1, "the window did not take the files");
        self.x.destroy_window(self.window).unwrap();
        self.x.flush().unwrap();
    }

    fn send(&self, message: &str, [a, b, c, d]: [u32; 4]) {
        let kind = atom(self.x, message);
        let event = ClientMessageEvent::new(32, self.target, kind, [self.window, a, b, c, d]);
        self.x
            .send_event(false, self.target, EventMask::NO_EVENT, event)
            .unwrap();
        self.x.flush().unwrap();
    }

    /// Waits for a message of the target, and hands it the list whenever it asks for it.
    fn wait_for(&self, message: &str, list: &str) -> [u32; 5] {
        let kind = atom(self.x, message);
        let start = Instant::now();
        while start.elapsed() < LIMIT {
            match self.x.poll_for_event().unwrap() {
                Some(Event::ClientMessage(event)) if event.type_ == kind => {
                    return event.data.as_data32();
                }
                Some(Event::SelectionRequest(request)) => self.hand_over(&request, list),
                Some(_) => {}
                None => std::thread::sleep(Duration::from_millis(5)),
            }
        }
        panic!("{message} did not come within {LIMIT:?}");
    }

    fn hand_over(&self, request: &xproto::SelectionRequestEvent, list: &str) {
        let (to, property) = (request.requestor, request.property);
        assert_eq!(request.target, self.uri_list, "another type was asked for");
        let bytes = list.as_bytes();
        self.x
            .change_property8(PropMode::REPLACE, to, property, self.uri_list, bytes)
            .unwrap();
        let notify = SelectionNotifyEvent {
            response_type: SELECTION_NOTIFY_EVENT,
            sequence: 0,
            time: request.time,
            requestor: to,
            selection: request.selection,
            target: request.target,
            property,
        };
        self.x
            .send_event(false, to, EventMask::NO_EVENT, notify)
            .unwrap();
        self.x.flush().unwrap();
    }
}
