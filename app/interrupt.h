// Ctrl-C and SIGTERM as a wish that loops look at. The second signal of a kind kills, as usual.
#pragma once

namespace wells {

/// Installs the handlers; call once, before any thread is started.
void catchInterrupts();

/// True once either signal has come.
bool interrupted();

}  // namespace wells
