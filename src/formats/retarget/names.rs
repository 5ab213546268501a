//! Names of joints in the rigs that are in use: CMU's and MotionBuilder's, Mixamo, LaFAN1, Perception
//! Neuron, Poser and Daz, Xsens, Rokoko, OptiTrack, Unreal, 3ds Max's Biped, Rigify, VRM, SMPL,
//! Bandai-Namco's, MikuMikuDance's in Japanese.
//!
//! They say the side in a word or a letter, before or after, and differ in what they call a bone: by
//! the bone itself, or by the joint that it begins at. Two words mean different bones in different
//! rigs: "shoulder" is the collar bone where there is an upper arm beside it, and "foot" is the ball
//! where there is an ankle.

use super::part::{Bone, Part, Side};

/// What a name says.
struct Words {
    side: Option<Side>,
    /// The rest, in lower case and without spaces.
    core: String,
}

/// Words that say nothing.
const NOISE: [&str; 12] = [
    "bip",
    "bip01",
    "bip001",
    "def",
    "mixamorig",
    "cc",
    "base",
    "j",
    "bone",
    "jnt",
    "jt",
    "joint",
];

/// Cuts a name at everything that is no letter or digit, and where a small letter or a digit is
/// followed by a capital one, or capitals by a capitalised word.
fn cut(name: &str) -> Vec<String> {
    let name = name.rsplit(':').next().unwrap_or(name);
    let letters: Vec<char> = name.chars().collect();
    let mut words: Vec<String> = vec![];
    let mut word = String::new();
    for (at, &letter) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|at| letters[at]);
        let after = letters.get(at + 1);
        let begins = letter.is_uppercase()
            && before.is_some_and(|before| {
                before.is_lowercase()
                    || before.is_ascii_digit()
                    || (before.is_uppercase() && after.is_some_and(|after| after.is_lowercase()))
            });
        if (begins || !letter.is_alphanumeric()) && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if letter.is_alphanumeric() {
            word.extend(letter.to_lowercase());
        }
    }
    words.push(word);
    words.retain(|word| !word.is_empty());
    words
}

/// The word that nearly every name begins with: the character's.
fn prefix(names: &[Vec<String>]) -> Option<String> {
    let first = |name: &Vec<String>| name.first().cloned();
    names.iter().filter_map(first).find(|word| {
        let same = |name: &&Vec<String>| name.len() > 1 && name.first() == Some(word);
        5 * names.iter().filter(same).count() >= 4 * names.len()
    })
}

impl Words {
    fn of(mut words: Vec<String>, prefix: Option<&str>) -> Self {
        if words.len() > 1 && words.first().map(String::as_str) == prefix {
            words.remove(0);
        }
        let side_of = |word: &str| match word {
            "left" | "l" => Some(Side::Left),
            "right" | "r" => Some(Side::Right),
            _ => None,
        };
        let mut side = None;
        words.retain(|word| {
            let own = side_of(word);
            side = side.or(own);
            own.is_none()
        });
        if words.len() > 1 {
            words.retain(|word| !NOISE.contains(&word.as_str()));
        }
        let mut core = words.concat();
        if side.is_none() {
            // "leftUpLeg" without a capital, "lthigh", "LUArm".
            for (start, own) in [
                ("left", Side::Left),
                ("right", Side::Right),
                ("l", Side::Left),
                ("r", Side::Right),
            ] {
                if let Some(rest) = core.strip_prefix(start)
                    && !candidates(rest).is_empty()
                {
                    side = Some(own);
                    core = rest.to_owned();
                    break;
                }
            }
        }
        Self { side, core }
    }
}

/// What a word without its side may be, the likeliest first.
fn candidates(core: &str) -> &'static [Bone] {
    match core {
        "collar" | "clavicle" | "collarbone" | "clav" => &[Bone::Clavicle],
        "shoulder" => &[Bone::Clavicle, Bone::UpperArm],
        "upperarm" | "uparm" | "arm" | "uarm" | "shldr" | "shldrbend" | "armupper" | "humerus" => {
            &[Bone::UpperArm]
        }
        "forearm" | "lowerarm" | "lowarm" | "farm" | "elbow" | "forearmbend" | "armlower"
        | "radius" => &[Bone::Forearm],
        "hand" | "wrist" | "palm" => &[Bone::Hand],
        "upleg" | "upperleg" | "thigh" | "thighbend" | "hip" | "legupper" | "femur" | "uleg" => {
            &[Bone::Thigh]
        }
        "leg" | "lowerleg" | "lowleg" | "shin" | "calf" | "knee" | "leglower" | "tibia"
        | "lleg" => &[Bone::Shin],
        "ankle" => &[Bone::Foot],
        "foot" => &[Bone::Foot, Bone::Toe],
        "toe" | "toebase" | "toes" | "ball" | "toe0" | "toe1" => &[Bone::Toe],
        _ => &[],
    }
}

const FINGERS: [&[&str]; 5] = [
    &["thumb"],
    &["index", "pointer"],
    &["middle", "mid"],
    &["ring"],
    &["pinky", "little", "pink"],
];

/// Which finger a word names: 0 is the thumb.
fn finger(core: &str) -> Option<usize> {
    // Bones of the palm carry a finger's name too, and so do toes.
    if ["inhand", "carpal", "palm", "toe", "foot", "end", "tip"]
        .iter()
        .any(|other| core.contains(other) && !core.contains("thumbmetacarpal"))
    {
        return None;
    }
    FINGERS
        .iter()
        .position(|names| names.iter().any(|name| core.contains(name)))
}

/// For each joint, which part its name says; a part may have several joints.
pub fn parts(names: &[String]) -> Vec<Option<Part>> {
    let cut: Vec<Vec<String>> = names.iter().map(|name| cut(name)).collect();
    let prefix = prefix(&cut);
    let words: Vec<Words> = cut
        .into_iter()
        .map(|words| Words::of(words, prefix.as_deref()))
        .collect();
    let has = |side: Option<Side>, bone: Bone| {
        words
            .iter()
            .any(|word| word.side == side && candidates(&word.core) == [bone])
    };
    let parts = words.iter().zip(names).map(|(word, name)| {
        part(word, &|bone| has(word.side, bone)).or_else(|| japanese_part(name.trim()))
    });
    parts.collect()
}

/// What MikuMikuDance calls a bone, without its side.
fn japanese(core: &str) -> Option<Bone> {
    Some(match core {
        "肩" => Bone::Clavicle,
        "腕" => Bone::UpperArm,
        "ひじ" | "肘" => Bone::Forearm,
        "手首" => Bone::Hand,
        "足" => Bone::Thigh,
        "ひざ" | "膝" => Bone::Shin,
        "足首" => Bone::Foot,
        "つま先" | "爪先" | "足先EX" | "足先ex" => Bone::Toe,
        _ => return None,
    })
}

/// The part that a name of MikuMikuDance says.
fn japanese_part(name: &str) -> Option<Part> {
    let sides = [('左', Side::Left), ('右', Side::Right)];
    let sided = sides.into_iter().find_map(|(letter, side)| {
        let core = name.strip_prefix(letter)?;
        Some((side, core))
    });
    let Some((side, core)) = sided else {
        return match name {
            "下半身" | "センター" => Some(Part::Hips),
            "首" => Some(Part::Neck),
            "頭" => Some(Part::Head),
            _ => None,
        };
    };
    if let Some(bone) = japanese(core) {
        return Some(Part::Bone { side, bone });
    }
    let fingers = ["親指", "人指", "中指", "薬指", "小指"];
    let finger = fingers.iter().position(|finger| core.starts_with(finger));
    match finger {
        Some(finger) => Some(Part::Finger { side, finger }),
        None => (core == "目").then_some(Part::Eye(side)),
    }
}

/// The part that a name says. `has`: whether a name of the same side says a bone and no other.
fn part(word: &Words, has: &dyn Fn(Bone) -> bool) -> Option<Part> {
    let core = word.core.as_str();
    let Some(side) = word.side else {
        return match core {
            "hips" | "hip" | "pelvis" => Some(Part::Hips),
            "head" => Some(Part::Head),
            "neck" | "neck1" | "neck01" => Some(Part::Neck),
            "jaw" => Some(Part::Jaw),
            _ => None,
        };
    };
    if core.contains("twist") || core.contains("roll") || core.contains("end") {
        return None;
    }
    if let Some(finger) = finger(core) {
        return Some(Part::Finger { side, finger });
    }
    if core == "eye" || core == "eyeball" {
        return Some(Part::Eye(side));
    }
    let bone = match candidates(core) {
        [first] => *first,
        [first, second] => match first {
            // The rig says "shoulder" for the upper arm if no other name does.
            Bone::Clavicle if !has(Bone::UpperArm) => *second,
            // "foot" is the ball if another name says the ankle.
            Bone::Foot if has(Bone::Foot) => *second,
            _ => *first,
        },
        _ => return None,
    };
    Some(Part::Bone { side, bone })
}
