//! The colours of face and clothes, display-referred sRGB as 0xRRGGBB.

pub(super) const SKIN: u32 = 0xE0AC8B;
pub(super) const LIPS_MALE: u32 = 0xB9756A;
pub(super) const LIPS_FEMALE: u32 = 0xB85D5A;
pub(super) const MOUTH: u32 = 0x5A2020;
pub(super) const TEETH: u32 = 0xE6DED0;
pub(super) const HAIR: u32 = 0x3A281C;
pub(super) const LASHES: u32 = 0x1A1210;

pub(super) const EYEBALL_BACK: u32 = 0xE8DCD4;
pub(super) const SCLERA: u32 = 0xF1ECE6;
pub(super) const SCLERA_RIM: u32 = 0xD9A79A;
pub(super) const LIMBAL_RING: u32 = 0x24333A;
pub(super) const IRIS_OUTER: u32 = 0x5B7F8C;
pub(super) const IRIS_INNER: u32 = 0x8A7A4E;
pub(super) const PUPIL: u32 = 0x050505;

pub(super) const SHIRT: u32 = 0x2F6E78;
pub(super) const SHIRT_STRIPE: u32 = 0x3F8791;
pub(super) const SHIRT_RIB: u32 = 0x1F4C56;
/// One for each of the emblem's Gaussians.
pub(super) const EMBLEM: [u32; 3] = [0xF2A65A, 0xE4604E, 0xF4D58D];
pub(super) const EMBLEM_WORD: u32 = 0xF6EFE0;

pub(super) const DENIM: u32 = 0x2C3A57;
pub(super) const DENIM_WORN: u32 = 0x5B7093;
pub(super) const DENIM_THREAD: u32 = 0xC98B4A;
pub(super) const BELT: u32 = 0x4A2E1D;
pub(super) const BUCKLE: u32 = 0xB9B2A2;
pub(super) const BUCKLE_HOLE: u32 = 0x3A2417;

pub(super) const SOCKS: u32 = 0x2B2D33;
pub(super) const CANVAS: u32 = 0x8C3B34;
pub(super) const TONGUE: u32 = 0x74302B;
pub(super) const LACES: u32 = 0xF4F1EA;
pub(super) const RUBBER: u32 = 0xEDEAE2;
pub(super) const SOLE: u32 = 0x4A4640;
