//! What tells persons apart: skin, hair, and the cut and colours of clothes. Colours are
//! display-referred sRGB as 0xRRGGBB.

/// A person's skin, hair and clothes.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    pub(super) skin: u32,
    /// Of the male and the female body.
    pub(super) lips: [u32; 2],
    pub(super) hair: u32,
    pub(super) iris_outer: u32,
    pub(super) iris_inner: u32,
    pub(super) shirt: u32,
    pub(super) shirt_stripe: u32,
    pub(super) shirt_rib: u32,
    /// Period of the shirt's stripes, metres.
    pub(super) stripe: f64,
    pub(super) denim: u32,
    pub(super) denim_worn: u32,
    pub(super) denim_thread: u32,
    pub(super) socks: u32,
    pub(super) canvas: u32,
    pub(super) tongue: u32,
    /// How far the sleeves reach: 0 at the shoulder, 1 at the elbow, on the forearm beyond.
    pub(super) sleeve: f64,
    /// How far the trousers reach: 0 at the knee, 1 at the ankle.
    pub(super) hem: f64,
    /// Where socks begin, in the hem's measure.
    pub(super) socks_top: f64,
}

impl Style {
    /// A teal T-shirt and blue jeans.
    pub const FIRST: Self = Self {
        skin: 0xE0AC8B,
        lips: [0xB9756A, 0xB85D5A],
        hair: 0x3A281C,
        iris_outer: 0x5B7F8C,
        iris_inner: 0x8A7A4E,
        shirt: 0x2F6E78,
        shirt_stripe: 0x3F8791,
        shirt_rib: 0x1F4C56,
        stripe: 0.015,
        denim: 0x2C3A57,
        denim_worn: 0x5B7093,
        denim_thread: 0xC98B4A,
        socks: 0x2B2D33,
        canvas: 0x8C3B34,
        tongue: 0x74302B,
        sleeve: 0.60,
        hem: 0.97,
        socks_top: f64::NEG_INFINITY,
    };
    /// Dark skin and hair, a rust jersey with wide stripes and three-quarter sleeves, khaki
    /// trousers to below the knee.
    pub const SECOND: Self = Self {
        skin: 0x7A4A33,
        lips: [0x6B3B36, 0x7A3F41],
        hair: 0x141110,
        iris_outer: 0x3B2618,
        iris_inner: 0x5A3B22,
        shirt: 0xA8452C,
        shirt_stripe: 0xE8DCC4,
        shirt_rib: 0x5C2218,
        stripe: 0.06,
        denim: 0x8A7B58,
        denim_worn: 0xA79874,
        denim_thread: 0x5E5238,
        socks: 0xE4E2DC,
        canvas: 0x2E4A3A,
        tongue: 0x24392D,
        sleeve: 1.45,
        hem: 0.35,
        socks_top: 0.72,
    };
}
