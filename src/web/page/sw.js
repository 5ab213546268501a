// A service worker that keeps the page for use without a network. tools/web.sh fills in the names of
// its files, and a stamp that changes with their contents.
const CACHE_PREFIX = `effigy ${registration.scope} `;
const CACHE = `${CACHE_PREFIX}@STAMP@`;
const FILES = ["./", "@FILES@"];
/** Kept once they have been used: most visitors open no file of another program. */
const LATER_FILES = ["@LATER@"];

/** Fetches all files past the browser's own cache: they must be of one version. */
async function install() {
  const cache = await caches.open(CACHE);
  await cache.addAll(FILES.map((file) => new Request(file, { cache: "reload" })));
  await self.skipWaiting();
}

/** Deletes earlier versions of this page. Other folders of the host have their own prefix. */
async function activate() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(CACHE_PREFIX) && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

async function respond(request) {
  const cache = await caches.open(CACHE);
  const kept = await cache.match(request, { ignoreSearch: true });
  if (kept) return kept;
  const response = await fetch(request);
  const isLater = LATER_FILES.some((file) => request.url === new URL(file, location).href);
  if (isLater && response.ok) await cache.put(request, response.clone());
  return response;
}

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));
self.addEventListener("fetch", (event) => {
  const isOurs = new URL(event.request.url).origin === location.origin;
  if (event.request.method === "GET" && isOurs) event.respondWith(respond(event.request));
});
