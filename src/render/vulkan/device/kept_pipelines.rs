//! Compute pipelines that renderers of one device share: a program that makes thousands of renderers,
//! one after the other, would spend most of its time in the driver's compiler.

use super::handle::{Pipeline, PipelineLayout, SetLayout};
use std::{
    collections::HashMap,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

/// All that a compute pipeline is made from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct PipelineKey {
    /// The module's file.
    pub module: &'static str,
    /// Specialization constants.
    pub constants: Vec<u32>,
    /// Required size of subgroups.
    pub subgroup: Option<u32>,
    /// Whether a dispatch may start anywhere.
    pub anywhere: bool,
    /// Whether there is a uniform block, how many storage buffers, and the image's kind: layouts
    /// that are equal in these are compatible.
    pub bindings: [u32; 3],
}

/// The layout of pipelines that use one set, and that of the set.
pub(crate) struct Layouts {
    pub pipeline: PipelineLayout,
    pub _set: SetLayout,
}

/// A compute pipeline, and what it was made with: before Vulkan 1.3 it may still need that.
pub(crate) struct SharedPipeline {
    pub pipeline: Pipeline,
    pub _layouts: Arc<Layouts>,
}

type Kept = HashMap<PipelineKey, Arc<SharedPipeline>>;

/// The pipelines. None while none are kept.
#[derive(Default)]
pub(crate) struct KeptPipelines(Mutex<Option<Kept>>);

impl KeptPipelines {
    /// Keeps every pipeline from now on.
    pub fn keep(&self) {
        self.lock().get_or_insert_default();
    }

    pub fn get(&self, key: &PipelineKey) -> Option<Arc<SharedPipeline>> {
        self.lock().as_ref()?.get(key).cloned()
    }

    /// Keeps a pipeline, if pipelines are kept.
    pub fn put(&self, key: PipelineKey, pipeline: &Arc<SharedPipeline>) {
        if let Some(kept) = self.lock().as_mut() {
            kept.insert(key, pipeline.clone());
        }
    }

    fn lock(&self) -> MutexGuard<'_, Option<Kept>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
