pub const TESTS: &[crate::common::harness::Test] = &[];
