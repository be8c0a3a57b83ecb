package lejos.internal.io;

/** Describes the brick's Bluetooth radio. */
public class NativeHCI {
    /** Creates an object nobody needs. */
    public NativeHCI() {}

    /** The radio as the operating system describes it; only the address says anything about a virtual brick. */
    public static class DeviceInfo {
        private static final byte[] ADDRESS = {0x01, 0x00, 0x00, 0x53, 0x16, 0x00};

        /** Number of the device. */
        public short dev_id;
        /** Name of the device. */
        public byte[] name = {'h', 'c', 'i', '0', 0, 0, 0, 0};
        /** Address, the last byte first. */
        public byte[] bdaddr = ADDRESS.clone();
        /** State flags. */
        public int flags;
        /** Kind of bus. */
        public byte type;
        /** Feature bits. */
        public byte[] features = new byte[8];
        /** Packet types. */
        public int pkt_type;
        /** Link policy. */
        public int link_policy;
        /** Link mode. */
        public int link_mode;
        /** Largest asynchronous packet. */
        public short acl_mtu;
        /** Number of asynchronous packets. */
        public short acl_pkts;
        /** Largest synchronous packet. */
        public short sco_mtu;
        /** Number of synchronous packets. */
        public short sco_pkts;
        /** Counters. */
        public int[] stat = new int[10];

        /** The radio of a virtual brick. */
        public DeviceInfo() {}
    }

    /** Versions of the radio; all 0 for a virtual brick. */
    public static class LocalVersion {
        /** Manufacturer. */
        public short manufacturer;
        /** Version of the host interface. */
        public byte hci_ver;
        /** Revision of the host interface. */
        public short hci_rev;
        /** Version of the link manager. */
        public byte lmp_ver;
        /** Subversion of the link manager. */
        public short lmp_subver;

        /** The radio of a virtual brick. */
        public LocalVersion() {}
    }
}
