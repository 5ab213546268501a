//! The numbers of an evaluation by group of views and by region, with the protocol that they hold
//! under.

use super::{
    metrics::{Means, Metrics},
    regions::Region,
    view::{ScoredView, Scorer},
    views::{PictureIndex, group},
};
use serde::Serialize;
use std::collections::BTreeMap;

/// How pictures were compared: numbers under other protocols can't be set beside these.
#[derive(Clone, Debug, Serialize)]
pub struct Protocol {
    /// The pixels that are compared.
    pub area: &'static str,
    /// What lies behind the person, in both pictures.
    pub background: String,
    /// Of the capture, or fitted to its pictures with the avatar frozen.
    pub poses: String,
    /// The perceptual distance's name; None: there is none.
    pub perceptual: Option<String>,
    /// What the regions are from.
    pub regions: &'static str,
}

/// The numbers of one view.
#[derive(Clone, Debug, Serialize)]
pub struct ViewScore {
    /// Name of the camera.
    pub camera: String,
    /// Number of the frame.
    pub frame: u32,
    /// [`GroupMeans::name`].
    pub group: &'static str,
    /// Over the mask's box.
    pub whole: Metrics,
    /// By region.
    pub regions: BTreeMap<Region, Metrics>,
}

/// The means of a group of views.
#[derive(Clone, Debug, Serialize)]
pub struct GroupMeans {
    /// What was held out.
    pub name: &'static str,
    /// Over the masks' boxes.
    pub whole: Means,
    /// By region, of the views that see it.
    pub regions: BTreeMap<Region, Means>,
}

/// An evaluation.
#[derive(Clone, Debug, Serialize)]
pub struct ScoreReport {
    /// How pictures were compared.
    pub protocol: Protocol,
    /// Means.
    pub groups: Vec<GroupMeans>,
    /// Every view.
    pub views: Vec<ViewScore>,
}

impl Scorer<'_> {
    /// How this compares.
    pub fn protocol(&self) -> Protocol {
        Protocol {
            area: "the smallest box around the truth's mask",
            background: self.ground.describe(),
            poses: self.poses.clone(),
            perceptual: self
                .perceptual
                .map(|perceptual| perceptual.network().title().to_owned()),
            regions: "the body model's joints that move what is seen most, inside the truth's mask",
        }
    }

    /// The numbers of a view with its names.
    pub fn named(&self, view: PictureIndex, compared: &ScoredView) -> ViewScore {
        ViewScore {
            camera: self.capture.cameras[view.camera].name.clone(),
            frame: self.capture.frames[view.frame].number,
            group: group(self.capture, view),
            whole: compared.whole,
            regions: compared.regions.clone(),
        }
    }
}

impl ScoreReport {
    /// Means of views, in the order in which their groups come first.
    pub fn new(protocol: Protocol, views: Vec<ViewScore>) -> Self {
        let mut names: Vec<&'static str> = Vec::new();
        for view in &views {
            if !names.contains(&view.group) {
                names.push(view.group);
            }
        }
        let groups = names
            .into_iter()
            .filter_map(|name| {
                let own = || views.iter().filter(|view| view.group == name);
                let regions = Region::ALL.into_iter().filter_map(|region| {
                    let metrics = own().filter_map(|view| view.regions.get(&region));
                    Some((region, Means::of(metrics)?))
                });
                Some(GroupMeans {
                    name,
                    regions: regions.collect(),
                    whole: Means::of(own().map(|view| &view.whole))?,
                })
            })
            .collect();
        Self {
            protocol,
            groups,
            views,
        }
    }
}
