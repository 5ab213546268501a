pub mod hostile; pub const TESTS: &[crate::common::harness::Test] = &[];
