//! Credits that go into the files made here.

/// Of avatars.
pub const BODY_CREDIT: &str = "Body, rig, skin weights and expressions: MakeHuman (makehumancommunity.org), \
    released under CC0 1.0. Clothes, hair and colours: Effigy.";
/// Of clips: the sentence that CMU asks for.
pub const MOTION_CREDIT: &str = "The data used in this project was obtained from mocap.cs.cmu.edu. The database \
    was created with funding from NSF EIA-0196217.";
