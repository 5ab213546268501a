//! The colours of face and clothes that every person has, display-referred sRGB as 0xRRGGBB. Those
//! that differ are in [`crate::bake::style`].

pub(super) const MOUTH: u32 = 0x5A2020;
pub(super) const TEETH: u32 = 0xE6DED0;
pub(super) const LASHES: u32 = 0x1A1210;

pub(super) const EYEBALL_BACK: u32 = 0xE8DCD4;
pub(super) const SCLERA: u32 = 0xF1ECE6;
pub(super) const SCLERA_RIM: u32 = 0xD9A79A;
pub(super) const LIMBAL_RING: u32 = 0x24333A;
pub(super) const PUPIL: u32 = 0x050505;

/// One for each of the emblem's Gaussians.
pub(super) const EMBLEM: [u32; 3] = [0xF2A65A, 0xE4604E, 0xF4D58D];
pub(super) const EMBLEM_WORD: u32 = 0xF6EFE0;

pub(super) const BELT: u32 = 0x4A2E1D;
pub(super) const BUCKLE: u32 = 0xB9B2A2;
pub(super) const BUCKLE_HOLE: u32 = 0x3A2417;

pub(super) const LACES: u32 = 0xF4F1EA;
pub(super) const RUBBER: u32 = 0xEDEAE2;
pub(super) const SOLE: u32 = 0x4A4640;
