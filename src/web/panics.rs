//! What a panic said. After one nothing here can be trusted any more: the page is told so instead of a bare `unreachable`.

use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    static SAID: RefCell<Option<String>> = const { RefCell::new(None) };
}

#[wasm_bindgen(start)]
fn listen() {
    std::panic::set_hook(Box::new(|panic| SAID.with(|said| *said.borrow_mut() = Some(panic.to_string()))));
}

/// Where and why this module panicked, if it did.
#[wasm_bindgen]
pub fn panicked() -> Option<String> {
    SAID.with(|said| said.borrow().clone())
}
