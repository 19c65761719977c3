/// A library that is loaded before talus_serve (LD_PRELOAD): the server begins to accept connections some time after it
/// has printed its address.
#include <dlfcn.h>
#include <httplib.h>

#include <chrono>
#include <thread>

bool httplib::Server::listen_after_bind() {
  std::this_thread::sleep_for(std::chrono::milliseconds{500});
  using Listen = bool (*)(Server*);
  return reinterpret_cast<Listen>(::dlsym(RTLD_NEXT, "_ZN7httplib6Server17listen_after_bindEv"))(this);
}
