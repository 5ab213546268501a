//! Calls into Java over JNI, for what the NDK does not offer. Every query returns a default if the
//! system does not answer.

use anyhow::bail;
use jni::{
    Env, JavaVM,
    errors::{Error, Result},
    jni_sig, jni_str,
    objects::{JObject, JObjectArray, JString, JValue},
    refs::Global,
};
use std::{
    fs::File,
    os::fd::{FromRawFd, OwnedFd},
};
use winit::platform::android::activity::AndroidApp;

/// SYSTEM_UI_FLAG_: IMMERSIVE_STICKY, FULLSCREEN, HIDE_NAVIGATION, and LAYOUT_STABLE, _FULLSCREEN
/// and _HIDE_NAVIGATION.
const IMMERSIVE: i32 = 0x1000 | 0x4 | 0x2 | 0x100 | 0x400 | 0x200;

/// FLAG_KEEP_SCREEN_ON of a window.
const KEEP_SCREEN_ON: i32 = 0x80;

/// Calls into Java on this thread, with the activity. An exception is caught and becomes the error.
fn call<T>(app: &AndroidApp, function: impl FnOnce(&mut Env, &JObject) -> Result<T>) -> Result<T> {
    let activity = app.activity_as_ptr().cast();
    // SAFETY: the glue hands out the process's own virtual machine.
    let machine = unsafe { JavaVM::from_raw(app.vm_as_ptr().cast()) };
    machine.attach_current_thread(|env| {
        // SAFETY: the glue keeps this global reference for as long as there is an `AndroidApp`.
        let activity = unsafe { env.as_cast_raw::<Global<JObject>>(&activity)? };
        function(env, &activity)
    })
}

/// Like [`call`], but logs an error and returns None. `what`: names the call in the log.
fn call_or_log<T>(
    app: &AndroidApp,
    what: &str,
    function: impl FnOnce(&mut Env, &JObject) -> Result<T>,
) -> Option<T> {
    match call(app, function) {
        Ok(value) => Some(value),
        Err(error) => {
            tracing::warn!("{what} failed: {error}");
            None
        }
    }
}

/// Calls into Java later, on the thread that owns the activity's views. Errors are logged. `what`:
/// names the call in the log.
fn call_on_main_thread(
    app: &AndroidApp,
    what: &'static str,
    function: impl FnOnce(&mut Env, &JObject) -> Result<()> + Send + 'static,
) {
    let later = app.clone();
    app.run_on_java_main_thread(Box::new(move || {
        call_or_log(&later, what, function);
    }));
}

/// The intent that the activity was started with.
fn intent<'e>(env: &mut Env<'e>, activity: &JObject) -> Result<JObject<'e>> {
    env.call_method(
        activity,
        jni_str!("getIntent"),
        jni_sig!("()Landroid/content/Intent;"),
        &[],
    )?
    .l()
}

/// The window of the activity.
fn window<'e>(env: &mut Env<'e>, activity: &JObject) -> Result<JObject<'e>> {
    let signature = jni_sig!("()Landroid/view/Window;");
    env.call_method(activity, jni_str!("getWindow"), signature, &[])?
        .l()
}

/// The display that the activity is on.
fn display<'e>(env: &mut Env<'e>, activity: &JObject) -> Result<JObject<'e>> {
    let manager = env
        .call_method(
            activity,
            jni_str!("getWindowManager"),
            jni_sig!("()Landroid/view/WindowManager;"),
            &[],
        )?
        .l()?;
    env.call_method(
        &manager,
        jni_str!("getDefaultDisplay"),
        jni_sig!("()Landroid/view/Display;"),
        &[],
    )?
    .l()
}

/// Whether the system is destroying the activity, and waits for this thread to end. winit does not
/// report it.
pub fn is_destroyed(app: &AndroidApp) -> bool {
    call_or_log(app, "asking for the activity's end", |env, activity| {
        env.call_method(activity, jni_str!("isDestroyed"), jni_sig!("()Z"), &[])?
            .z()
    })
    .unwrap_or(false)
}

/// Does what the system's back button does by default.
pub fn back(app: &AndroidApp) {
    call_on_main_thread(app, "going back", |env, activity| {
        env.call_method(activity, jni_str!("onBackPressed"), jni_sig!("()V"), &[])?
            .v()
    });
}

/// Fills the screen: the system's bars come back for a moment when they are swiped in.
pub fn hide_bars(app: &AndroidApp) {
    call_on_main_thread(app, "hiding the system's bars", |env, activity| {
        let window = window(env, activity)?;
        let view = env
            .call_method(
                &window,
                jni_str!("getDecorView"),
                jni_sig!("()Landroid/view/View;"),
                &[],
            )?
            .l()?;
        env.call_method(
            &view,
            jni_str!("setSystemUiVisibility"),
            jni_sig!("(I)V"),
            &[JValue::Int(IMMERSIVE)],
        )?
        .v()
    });
}

/// Keeps the screen from going dark without touches, or no longer. The glue's own call would wait
/// for the events that it is called from.
pub fn keep_screen_on(app: &AndroidApp, on: bool) {
    call_on_main_thread(app, "keeping the screen on", move |env, activity| {
        let window = window(env, activity)?;
        let name = if on {
            jni_str!("addFlags")
        } else {
            jni_str!("clearFlags")
        };
        let flags = [JValue::Int(KEEP_SCREEN_ON)];
        env.call_method(&window, name, jni_sig!("(I)V"), &flags)?
            .v()
    });
}

/// The highest refresh rate of the activity's display, Hz.
pub fn highest_rate(app: &AndroidApp) -> Option<f32> {
    let rate = call_or_log(app, "asking for the display's rates", |env, activity| {
        let display = display(env, activity)?;
        let modes = env
            .call_method(
                &display,
                jni_str!("getSupportedModes"),
                jni_sig!("()[Landroid/view/Display$Mode;"),
                &[],
            )?
            .l()?;
        let modes = env.cast_local::<JObjectArray>(modes)?;
        let mut highest = 0.0_f32;
        for number in 0..modes.len(env)? {
            let mode = modes.get_element(env, number)?;
            highest = highest.max(
                env.call_method(&mode, jni_str!("getRefreshRate"), jni_sig!("()F"), &[])?
                    .f()?,
            );
        }
        Ok(highest)
    });
    rate.filter(|&rate| rate > 0.0)
}

/// The current refresh rate of the activity's display, Hz: its mode's, or less if the system limits
/// the app to less.
pub fn refresh_rate(app: &AndroidApp) -> Option<f64> {
    let rate = call_or_log(app, "asking for the display's rate", |env, activity| {
        let display = display(env, activity)?;
        env.call_method(&display, jni_str!("getRefreshRate"), jni_sig!("()F"), &[])?
            .f()
    });
    rate.map(f64::from)
        .filter(|rate| rate.is_finite() && *rate > 0.0)
}

/// Minutes of what the activity was started for, `soak` or `survey`: `adb shell am start -S -n …
/// --ef soak 20`. `default`: where the number is none.
pub fn minutes(app: &AndroidApp, name: &str, default: f32) -> Option<f64> {
    call_or_log(app, "reading the intent", |env, activity| {
        let intent = intent(env, activity)?;
        let name = env.new_string(name)?;
        if !env
            .call_method(
                &intent,
                jni_str!("hasExtra"),
                jni_sig!("(Ljava/lang/String;)Z"),
                &[JValue::Object(&name)],
            )?
            .z()?
        {
            return Ok(None);
        }
        let arguments = [JValue::Object(&name), JValue::Float(default)];
        let minutes = env
            .call_method(
                &intent,
                jni_str!("getFloatExtra"),
                jni_sig!("(Ljava/lang/String;F)F"),
                &arguments,
            )?
            .f()?;
        Ok(Some(f64::from(minutes)))
    })
    .flatten()
    .filter(|minutes| minutes.is_finite() && *minutes > 0.0)
}

/// Whether another app has opened a file with this one.
pub fn has_opened(app: &AndroidApp) -> bool {
    call_or_log(app, "reading the intent's action", |env, activity| {
        let intent = intent(env, activity)?;
        let action = env
            .call_method(
                &intent,
                jni_str!("getAction"),
                jni_sig!("()Ljava/lang/String;"),
                &[],
            )?
            .l()?;
        Ok(!action.is_null()
            && env.cast_local::<JString>(action)?.try_to_string(env)?
                == "android.intent.action.VIEW")
    })
    .unwrap_or(false)
}

/// The file that another app has opened with this one, by the intent that started the activity. It
/// may have to be downloaded first, so call this on a thread that may wait.
pub fn opened_file(app: &AndroidApp) -> anyhow::Result<File> {
    let file = call(app, |env, activity| {
        let intent = intent(env, activity)?;
        let uri = env
            .call_method(
                &intent,
                jni_str!("getData"),
                jni_sig!("()Landroid/net/Uri;"),
                &[],
            )?
            .l()?;
        let resolver = jni_sig!("()Landroid/content/ContentResolver;");
        let resolver = env
            .call_method(activity, jni_str!("getContentResolver"), resolver, &[])?
            .l()?;
        let mode = env.new_string("r")?;
        let open =
            jni_sig!("(Landroid/net/Uri;Ljava/lang/String;)Landroid/os/ParcelFileDescriptor;");
        let arguments = [JValue::Object(&uri), JValue::Object(&mode)];
        let file = env
            .call_method(&resolver, jni_str!("openFileDescriptor"), open, &arguments)?
            .l()?;
        if file.is_null() {
            return Ok(None);
        }
        let number = env
            .call_method(&file, jni_str!("detachFd"), jni_sig!("()I"), &[])?
            .i()?;
        // SAFETY: detached from its Java object, the descriptor is ours alone.
        Ok(Some(File::from(unsafe { OwnedFd::from_raw_fd(number) })))
    });
    match file {
        Ok(Some(file)) => Ok(file),
        Ok(None) => {
            bail!("the other app provides no file: save it on the phone first, and open that")
        }
        Err(Error::CaughtJavaException { name, msg, .. }) => bail!("the system says {name}: {msg}"),
        Err(error) => bail!("{error}"),
    }
}

/// Shares a text: the user chooses the app.
pub fn share(app: &AndroidApp, text: String) {
    call_on_main_thread(app, "sharing", move |env, activity| {
        let action = env.new_string("android.intent.action.SEND")?;
        let intent = env.new_object(
            jni_str!("android/content/Intent"),
            jni_sig!("(Ljava/lang/String;)V"),
            &[JValue::Object(&action)],
        )?;
        let kind = env.new_string("text/plain")?;
        let set = jni_sig!("(Ljava/lang/String;)Landroid/content/Intent;");
        env.call_method(&intent, jni_str!("setType"), set, &[JValue::Object(&kind)])?;
        let name = env.new_string("android.intent.extra.TEXT")?;
        let text = env.new_string(&text)?;
        let put = jni_sig!("(Ljava/lang/String;Ljava/lang/String;)Landroid/content/Intent;");
        env.call_method(
            &intent,
            jni_str!("putExtra"),
            put,
            &[JValue::Object(&name), JValue::Object(&text)],
        )?;
        env.call_method(
            activity,
            jni_str!("startActivity"),
            jni_sig!("(Landroid/content/Intent;)V"),
            &[JValue::Object(&intent)],
        )?
        .v()
    });
}
