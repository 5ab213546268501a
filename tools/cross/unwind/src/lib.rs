//! `libunwind.a` without an NDK: Rust's standard library asks for the `_Unwind_*` functions on Android, and `unwinding` has them in Rust.
#![no_std]

extern crate unwinding;

unsafe extern "C" {
    fn abort() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // SAFETY: it takes nothing and does not return.
    unsafe { abort() }
}
