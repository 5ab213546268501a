// A Gaussian's footprint in the image (model.md, step 8), as the renderer and the training see it.

struct Footprint {
    // The Gaussian's axes, one standard deviation long, along x and along y of the image, px.
    vec3 across;
    vec3 down;
    // Variance of x, covariance, variance of y, with the low-pass, px².
    vec3 covariance;
    // Determinant of the covariance without the low-pass, and with it.
    float unfiltered;
    float determinant;
};

// `p`: the mean in camera space, metres; `slope`: x/z and y/z of the perspective's derivative. The
// columns of `axes` are the Gaussian's axes in some space, `rows` those of the matrix from there to
// the camera.
Footprint footprint_of(vec3 p, vec2 focal, vec2 slope, mat3 rows, mat3 axes, float low_pass) {
    Footprint footprint;
    vec3 mu = focal.x / p.z * (rows[0] - slope.x * rows[2]) * axes;
    vec3 mv = focal.y / p.z * (rows[1] - slope.y * rows[2]) * axes;
    footprint.across = mu;
    footprint.down = mv;
    footprint.covariance = vec3(dot(mu, mu) + low_pass, dot(mu, mv), dot(mv, mv) + low_pass);
    // |u × v|² is the determinant of the covariance before the low-pass (Lagrange), free of
    // cancellation for needles.
    vec3 normal = cross(mu, mv);
    footprint.unfiltered = dot(normal, normal);
    footprint.determinant = footprint.unfiltered +
        low_pass * (footprint.covariance.x + footprint.covariance.z - low_pass);
    return footprint;
}

// Whether it can be drawn. NaN fails.
bool is_drawable(Footprint footprint) {
    return footprint.determinant > 0.0 && footprint.covariance.x <= VARIANCE_MAX &&
        footprint.covariance.z <= VARIANCE_MAX;
}
