// The key of a splat. The including shader declares `splats`, the splats' buffer as vectors of four
// words.
uint key_at(uint i) {
    uint word = frame.key_start + i;
    return splats[word >> 2u][word & 3u];
}
