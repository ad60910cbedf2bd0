"""A fake desktop portal for a test, on the session's bus: fake_portal.py FOLDER.

The file FOLDER/answer determines the answer to a dialog: "fail" (there is no dialog), "cancel", or
a URI. Each request is appended to FOLDER/asked as a line of JSON. The theme is the number in
FOLDER/scheme; on SIGUSR1 the portal announces that it has changed.
"""

import json
import signal
import sys
from pathlib import Path

import dbus
import dbus.mainloop.glib
import dbus.service
from gi.repository import GLib

NAME = "org.freedesktop.portal.Desktop"
PATH = "/org/freedesktop/portal/desktop"
CHOOSER = "org.freedesktop.portal.FileChooser"
SETTINGS = "org.freedesktop.portal.Settings"
APPEARANCE = "org.freedesktop.appearance"


class Request(dbus.service.Object):
    @dbus.service.signal("org.freedesktop.portal.Request", signature="ua{sv}")
    def Response(self, how, results):
        pass

    @dbus.service.method("org.freedesktop.portal.Request")
    def Close(self):
        self.remove_from_connection()


class Portal(dbus.service.Object):
    def __init__(self, bus, folder):
        super().__init__(bus, PATH)
        self.bus = bus
        self.folder = folder

    def scheme(self):
        number = int((self.folder / "scheme").read_text())
        return dbus.UInt32(number, variant_level=1)

    @dbus.service.method(SETTINGS, in_signature="ss", out_signature="v")
    def Read(self, group, key):
        if (group, key) != (APPEARANCE, "color-scheme"):
            raise dbus.DBusException("no such setting", name="org.freedesktop.portal.Error.NotFound")
        return dbus.UInt32(self.scheme(), variant_level=2)

    @dbus.service.signal(SETTINGS, signature="ssv")
    def SettingChanged(self, group, key, value):
        pass

    def announce(self):
        self.SettingChanged("org.freedesktop.other", "color-scheme", dbus.UInt32(9))
        self.SettingChanged(APPEARANCE, "color-scheme", self.scheme())
        return True

    def answer(self, method, parent, options, sender):
        said = (self.folder / "answer").read_text()
        if said == "fail":
            raise dbus.DBusException("no dialogs", name="org.freedesktop.DBus.Error.UnknownMethod")
        asked = {"method": method, "parent": str(parent), "filter": str(options["filters"][0][1][0][1]),
                 "folder": bytes(options["current_folder"]).rstrip(b"\0").decode(),
                 "name": str(options.get("current_name", ""))}
        with open(self.folder / "asked", "a", encoding="utf-8") as file:
            file.write(json.dumps(asked) + "\n")
        place = f"{PATH}/request/{sender[1:].replace('.', '_')}/{options['handle_token']}"
        request = Request(self.bus, place)
        how, uris = (1, []) if said == "cancel" else (0, [said])
        GLib.idle_add(lambda: request.Response(
            dbus.UInt32(how), {"choices": dbus.Array([], "(ss)"),
                               "uris": dbus.Array(uris, "s")}) and False)
        return dbus.ObjectPath(place)

    @dbus.service.method(CHOOSER, in_signature="ssa{sv}", out_signature="o",
                         sender_keyword="sender")
    def OpenFile(self, parent, title, options, sender=None):
        return self.answer("OpenFile", parent, options, sender)

    @dbus.service.method(CHOOSER, in_signature="ssa{sv}", out_signature="o",
                         sender_keyword="sender")
    def SaveFile(self, parent, title, options, sender=None):
        return self.answer("SaveFile", parent, options, sender)


def run():
    dbus.mainloop.glib.DBusGMainLoop(set_as_default=True)
    bus = dbus.SessionBus()
    portal = Portal(bus, Path(sys.argv[1]))
    name = dbus.service.BusName(NAME, bus)
    GLib.unix_signal_add(GLib.PRIORITY_DEFAULT, signal.SIGUSR1, portal.announce)
    print(name.get_name(), flush=True)
    GLib.MainLoop().run()


if __name__ == "__main__":
    run()
