//! Draws for minutes on end, and says every second how it goes.

pub mod cadence;
