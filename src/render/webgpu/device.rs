//! A WebGPU device with the default limits, and its reports of loss and errors.

use super::error::{Error, Result};
use std::{
    future::poll_fn,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    task::{Poll, Waker},
};
use wgpu::{DeviceType, Features, Limits};

/// Loss and errors that the device's callbacks reported.
#[derive(Debug, Default)]
struct Reported {
    lost: Option<String>,
    /// Wakers of tasks that wait for the loss.
    waiting: Vec<Waker>,
    /// The first error that [`Gpu::check`] has not returned yet.
    error: Option<String>,
}

/// A device, shared by all that is made with it.
pub struct Gpu {
    /// The instance that the adapter comes from.
    pub instance: wgpu::Instance,
    /// The physical device.
    pub adapter: wgpu::Adapter,
    /// The logical device.
    pub device: wgpu::Device,
    /// Its one queue.
    pub queue: wgpu::Queue,
    /// Name, kind and driver of the adapter.
    pub info: wgpu::AdapterInfo,
    /// Whether passes can be timed.
    pub timestamps: bool,
    reported: Arc<Mutex<Reported>>,
}

/// A poisoned lock holds what it held: no writer leaves it half written.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Gpu {
    /// Opens a device of an instance, which in a browser may belong to a page. `wanted`: part of
    /// its name; None takes the fastest.
    ///
    /// # Errors
    /// Without such a device.
    pub async fn new(instance: wgpu::Instance, wanted: Option<&str>) -> Result<Arc<Self>> {
        let adapter = adapter(&instance, wanted).await?;
        let timestamps = adapter.features().contains(Features::TIMESTAMP_QUERY);
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("effigy"),
            required_features: if timestamps {
                Features::TIMESTAMP_QUERY
            } else {
                Features::empty()
            },
            required_limits: limits(&adapter),
            ..Default::default()
        };
        let opened = adapter.request_device(&descriptor).await;
        let (device, queue) = opened.map_err(|error| Error::NoDevice(error.to_string()))?;
        let reported = Arc::new(Mutex::new(Reported::default()));
        let callback = reported.clone();
        device.set_device_lost_callback(move |reason, message| {
            let mut reported = locked(&callback);
            reported.lost = Some(if message.is_empty() {
                format!("{reason:?}")
            } else {
                message
            });
            reported.waiting.drain(..).for_each(Waker::wake);
        });
        let callback = reported.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            tracing::error!("{error}");
            locked(&callback)
                .error
                .get_or_insert_with(|| error.to_string());
        }));
        let info = adapter.get_info();
        Ok(Arc::new(Self {
            instance,
            adapter,
            device,
            queue,
            info,
            timestamps,
            reported,
        }))
    }

    /// Opens a device without a browser.
    ///
    /// # Errors
    /// Without such a device.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn open(wanted: Option<&str>) -> Result<Arc<Self>> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            backends: wgpu::Backends::VULKAN,
            flags: if std::env::var_os("EFFIGY_VALIDATION").is_some() {
                wgpu::InstanceFlags::debugging()
            } else {
                wgpu::InstanceFlags::empty()
            },
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        pollster::block_on(Self::new(instance, wanted))
    }

    /// Whether the driver runs on the CPU.
    pub fn is_cpu(&self) -> bool {
        self.info.device_type == DeviceType::Cpu
            || self.info.name.to_ascii_lowercase().contains("swiftshader")
    }

    /// Its driver and the driver's build, as far as the device names them.
    pub fn driver(&self) -> String {
        format!("{} {}", self.info.driver, self.info.driver_info)
            .trim()
            .to_string()
    }

    /// Its name, as far as it gives one.
    pub fn name(&self) -> &str {
        let names = [&self.info.name, &self.info.driver];
        names
            .into_iter()
            .find(|name| !name.is_empty())
            .map_or("the browser's device", |name| name)
    }

    /// Bytes of its memory in use, and in blocks that the program took; zeros where the backend has
    /// no report.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn memory(&self) -> (u64, u64) {
        self.device
            .generate_allocator_report()
            .map_or((0, 0), |report| {
                (report.total_allocated_bytes, report.total_reserved_bytes)
            })
    }

    /// Why nothing can be drawn any more, or what the device refused since the last call.
    ///
    /// # Errors
    /// When it was lost or refused something.
    pub fn check(&self) -> Result<()> {
        let mut reported = locked(&self.reported);
        let error = reported.error.take();
        match (&reported.lost, error) {
            (Some(reason), _) => Err(Error::DeviceLost(reason.clone())),
            (None, Some(error)) => Err(Error::Refused(error)),
            (None, None) => Ok(()),
        }
    }

    /// Gives the device and all that was made with it back: it is lost from now on.
    pub fn close(&self) {
        locked(&self.reported)
            .lost
            .get_or_insert_with(|| "it was given back".into());
        self.device.destroy();
    }

    /// Ends when the device is lost, and says why. It does not keep the device.
    pub fn lost(&self) -> impl Future<Output = String> + use<> {
        let reported = self.reported.clone();
        poll_fn(move |context| {
            let mut reported = locked(&reported);
            if let Some(reason) = &reported.lost {
                return Poll::Ready(reason.clone());
            }
            reported.waiting.push(context.waker().clone());
            Poll::Pending
        })
    }

    /// From here on what the device refuses is not an error of [`Self::check`], but of the
    /// [`ErrorScope`].
    pub fn watch(&self) -> ErrorScope {
        use wgpu::ErrorFilter::{Internal, OutOfMemory, Validation};
        ErrorScope(
            [Internal, OutOfMemory, Validation].map(|filter| self.device.push_error_scope(filter)),
        )
    }

    /// Waits for what was submitted so far, or for all of it, but not forever.
    ///
    /// # Errors
    /// When the device is lost, refused something, or hangs.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn wait(
        &self,
        submission: Option<wgpu::SubmissionIndex>,
        what: &'static str,
    ) -> Result<()> {
        /// A frame of the largest image takes a CPU driver some seconds.
        const LIMIT: std::time::Duration = std::time::Duration::from_secs(60);
        let waited = self.device.poll(wgpu::PollType::Wait {
            submission_index: submission,
            timeout: Some(LIMIT),
        });
        self.check()?;
        waited.map(|_| ()).map_err(|_| Error::Timeout {
            what,
            seconds: LIMIT.as_secs(),
        })
    }
}

/// Errors of objects made since [`Gpu::watch`]. Browsers report them later.
pub struct ErrorScope([wgpu::ErrorScopeGuard; 3]);

impl ErrorScope {
    /// Closes the scope. The future ends once the device has reported.
    ///
    /// # Errors
    /// When the device refused something within the scope.
    pub fn end(self) -> impl Future<Output = Result<()>> + use<> {
        // The last scope opened is the first to be closed.
        let [internal, memory, validation] = self.0;
        let validation = validation.pop();
        let memory = memory.pop();
        let internal = internal.pop();
        async move {
            let errors = [validation.await, memory.await, internal.await];
            errors
                .into_iter()
                .flatten()
                .next()
                .map_or(Ok(()), |error| Err(Error::Refused(error.to_string())))
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
async fn adapter(instance: &wgpu::Instance, wanted: Option<&str>) -> Result<wgpu::Adapter> {
    let adapters = instance.enumerate_adapters(wgpu::Backends::VULKAN).await;
    let names: Vec<String> = adapters
        .iter()
        .map(|adapter| format!("`{}`", adapter.get_info().name))
        .collect();
    let Some(wanted) = wanted else {
        let best =
            adapters
                .into_iter()
                .min_by_key(|adapter| match adapter.get_info().device_type {
                    DeviceType::DiscreteGpu => 0,
                    DeviceType::IntegratedGpu => 1,
                    DeviceType::VirtualGpu | DeviceType::Other => 2,
                    DeviceType::Cpu => 3,
                });
        return best
            .ok_or_else(|| Error::NoDevice("none of this machine's drivers offers one".into()));
    };
    let fits = |adapter: &wgpu::Adapter| {
        adapter
            .get_info()
            .name
            .to_lowercase()
            .contains(&wanted.to_lowercase())
    };
    let found = adapters.into_iter().find(fits);
    found.ok_or_else(|| Error::NoSuchDevice {
        wanted: wanted.into(),
        found: names.join(", "),
    })
}

#[cfg(target_arch = "wasm32")]
async fn adapter(instance: &wgpu::Instance, _: Option<&str>) -> Result<wgpu::Adapter> {
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..Default::default()
    };
    instance
        .request_adapter(&options)
        .await
        .map_err(|error| Error::NoDevice(error.to_string()))
}

/// WebGPU's defaults, but for the size of images, of which a device may allow more.
fn limits(adapter: &wgpu::Adapter) -> Limits {
    let side = adapter.limits().max_texture_dimension_2d;
    Limits {
        max_texture_dimension_2d: side.max(Limits::default().max_texture_dimension_2d),
        ..Limits::default()
    }
}
