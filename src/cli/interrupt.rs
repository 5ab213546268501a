//! Ctrl-C and SIGTERM for commands that end in order.

use anyhow::Context;
use std::sync::{Arc, atomic::AtomicBool};

/// A flag that Ctrl-C, SIGTERM and a closed terminal set. A second Ctrl-C ends the program at once.
pub fn interrupts() -> anyhow::Result<Arc<AtomicBool>> {
    let stop = Arc::new(AtomicBool::new(false));
    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    {
        use signal_hook::{
            consts::{SIGHUP, SIGINT, SIGTERM},
            flag,
        };
        let failed = "Ctrl-C can't be listened to";
        flag::register_conditional_shutdown(SIGINT, 130, stop.clone()).context(failed)?;
        flag::register(SIGINT, stop.clone()).context(failed)?;
        flag::register(SIGTERM, stop.clone()).context(failed)?;
        flag::register(SIGHUP, stop.clone()).context(failed)?;
    }
    Ok(stop)
}
