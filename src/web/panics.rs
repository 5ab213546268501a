//! Keeps the message of a panic. After one, the module's state can't be trusted any more: the page
//! shows this message instead of a bare `unreachable`.

use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    static MESSAGE: RefCell<Option<String>> = const { RefCell::new(None) };
}

#[wasm_bindgen(start)]
fn install_hook() {
    std::panic::set_hook(Box::new(|panic| {
        MESSAGE.with(|message| *message.borrow_mut() = Some(panic.to_string()));
    }));
}

/// Where and why this module panicked, if it did.
#[wasm_bindgen]
pub fn panicked() -> Option<String> {
    MESSAGE.with(|message| message.borrow().clone())
}
