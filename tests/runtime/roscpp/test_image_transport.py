# SPDX-License-Identifier: BSD-3-Clause
"""The wrappers of image_transport and message_filters, raw and through a compressed transport."""
import json
import os

from topic_case import NODES, TZC_RUN, Listener, TopicCase, main

JPEG_TRANSPORT = os.path.join(os.path.dirname(NODES.rstrip("/")), "jpeg_transport")


class ImageTransport(TopicCase):
    session_env = {"ROS_PACKAGE_PATH": os.pathsep.join(filter(None, [
        JPEG_TRANSPORT, os.environ.get("ROS_PACKAGE_PATH", "/usr/share")]))}

    def view(self, transport="raw", **parameters):
        suffix = "" if transport == "raw" else f"/{transport}"
        viewer = self.node("camera", "viewer_" + transport, dict(parameters, role="viewer", transport=transport))
        self.wait_for_subscribers(self.name("second" + suffix), 1)
        return Listener(viewer)

    def film(self, runner=(), **parameters):
        camera = self.node("camera", "camera", dict({"count": 50}, **parameters), runner=runner)
        self.assertEqual(camera.wait(40), 0, camera.tail())
        if "kept" in parameters:
            return None
        return json.loads([line for line in camera.log().splitlines() if line.startswith("{")][-1])

    def test_every_way_to_publish(self):
        """A message for two topics goes out on both without a copy; a stock one is copied once for each."""
        viewer = self.view()
        for stock in ("false", "true"):
            for pointer in ("false", "true"):
                with self.subTest(stock=stock, pointer=pointer):
                    before = len(viewer.messages())
                    counters = self.film(stock=stock, pointer=pointer)
                    self.assertEqual(counters["copied_bytes"], 0 if stock == "false" else 2 * 50 * 64 * 64)
                    self.ros.wait_until(lambda: len(viewer.messages()) >= before + 150, 10, "three callbacks' images")
                    for callback in ("camera", "image", "both"):
                        mine = [m for m in viewer.messages()[before:] if m["callback"] == callback]
                        self.assertEqual([m["number"] for m in mine], list(range(50)), callback)
                        self.assertTrue(all(m["right"] for m in mine))
                        self.assertTrue(all(m["shared"] for m in mine) or callback == "both", callback)

    def test_attached_to_publishers_that_others_advertised(self):
        viewer = self.view()
        counters = self.film(attached="true")
        self.assertEqual(counters["copied_bytes"], 0)
        for callback in ("camera", "image"):
            self.assert_got(viewer, range(50), shared=True, callback=callback)
        self.assert_got(viewer, range(50), callback="both")

    def test_attached_to_publishers_that_stay(self):
        for pointer in ("false", "true"):
            with self.subTest(pointer=pointer):
                self.ros.stop_since(self.before)
                viewer = self.view()
                self.film(kept="true", pointer=pointer)
                for callback in ("camera", "image"):
                    self.assert_got(viewer, range(50), shared=True, callback=callback)
                self.assert_got(viewer, range(50), callback="both")

    def test_a_camera_that_is_not_ported_and_does_not_spin(self):
        """Its publishers have callbacks of image_transport's, in a queue that it never calls."""
        viewer = self.view()
        self.film(kept="true", plain="true", runner=TZC_RUN)
        for callback in ("camera", "image"):
            self.assert_got(viewer, range(50), shared=True, callback=callback)

    def test_publishers_that_stay_and_images_in_shared_memory(self):
        """tzc::image_transport::publish, by reference and pointer; a stock image is copied once for each topic."""
        for stock in ("false", "true"):
            for pointer in ("false", "true"):
                with self.subTest(stock=stock, pointer=pointer):
                    self.ros.stop_since(self.before)
                    viewer = self.view()
                    counters = self.film(calls="true", stock=stock, pointer=pointer)
                    self.assertEqual(counters["copied_bytes"], 0 if stock == "false" else 2 * 50 * 256 * 256)
                    for callback in ("camera", "image", "both"):
                        self.assert_got_behind_the_first(viewer, callback)

    def test_filters_that_stay(self):
        """image_transport's reads shared memory, message_filters' gets copies of it; also when it has subscribed again."""
        viewer = self.view(kept="true")
        counters = self.film(stock="true")
        self.assertEqual(counters["copied_bytes"], 2 * 50 * 64 * 64)  # and none for what goes over TCPROS
        self.assert_got(viewer, range(50), shared=True, callback="image")
        self.assert_got(viewer, range(50), shared=False, callback="second")

    def assert_got_behind_the_first(self, viewer, callback):
        """All 50; the message that attached the topics may have come, too."""
        def messages():
            return [m for m in viewer.messages(callback=callback) if m["number"] < 50]
        self.ros.wait_until(lambda: len(messages()) >= 50, 10, callback)
        self.assertEqual([m["number"] for m in messages()], list(range(50)), callback)
        self.assertTrue(all(m["right"] for m in messages()))
        self.assertTrue(all(m["shared"] for m in messages()) or callback == "both", callback)

    def test_a_name_that_is_remapped_to_a_remapped_one(self):
        """image_transport resolves what it advertises twice, so this camera's images go to `other`."""
        viewer = Listener(self.node("camera", "viewer", {"role": "viewer"}, ["image:=other"]))
        self.wait_for_subscribers(self.name("second"), 1)
        camera = self.node("camera", "camera", {"count": 50}, ["image:=pictures", "pictures:=other"])
        self.assertEqual(camera.wait(40), 0, camera.tail())
        self.assert_got(viewer, range(50), shared=True, callback="camera")

    def test_nothing_is_copied_for_plain_viewers_of_stock_messages(self):
        """Which the library serializes once, and so does the port."""
        for pointer in ("false", "true"):
            with self.subTest(pointer=pointer):
                self.ros.stop_since(self.before)
                viewer = self.view(plain="true")
                counters = self.film(stock="true", pointer=pointer)
                self.assertEqual(counters["copied_bytes"], 0)
                for callback in ("camera", "image"):
                    self.assert_got(viewer, range(50), shared=False, callback=callback)

    def test_nothing_is_copied_for_nobody(self):
        for stock in ("false", "true"):
            for pointer in ("false", "true"):
                with self.subTest(stock=stock, pointer=pointer):
                    self.assertEqual(self.film(stock=stock, pointer=pointer, subscribers=0, count=5)["copied_bytes"], 0)

    def test_compressed_beside_raw(self):
        raw, compressed = self.view(), self.view("compressed")
        self.film(subscribers=2)
        for callback in ("camera", "image"):
            self.assert_got(raw, range(50), shared=True, callback=callback)
            self.ros.wait_until(lambda: len(compressed.numbers(callback=callback)) >= 50, 10, "compressed images")
            self.assertEqual(compressed.numbers(callback=callback), list(range(50)))
            self.assertFalse(any(m["shared"] for m in compressed.messages(callback=callback)))

    def test_other_topics_do_not_wait_while_an_image_is_compressed(self):
        """roscpp publishes on all topics of a process under one mutex."""
        for transports in (["compressed"], ["compressed", "raw"]):
            with self.subTest(transports=transports):
                self.ros.stop_since(self.before)
                for transport in transports:
                    self.view(transport)
                counters = self.film(role="busy_camera", subscribers=len(transports))
                # Of ten images. If they had to wait, one or two would fit in before and behind each.
                self.assertGreater(counters["meanwhile"], 40)


if __name__ == "__main__":
    main()
