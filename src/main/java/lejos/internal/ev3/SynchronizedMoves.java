package lejos.internal.ev3;

import brickless.hardware.MotorSnapshot;
import brickless.hardware.MoveRequest;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.motor.MotorRegulator;

/**
 * Starts moves of several motors in the same control tick: between start and end moves are recorded, then sent
 * together.
 */
final class SynchronizedMoves {
    private final EV3MotorRegulator master;
    /** Guarded by this. */
    private List<EV3MotorRegulator> partners = List.of();
    /** The motors of the open block, empty when none is open. Guarded by this. */
    private List<EV3MotorRegulator> block = List.of();

    SynchronizedMoves(EV3MotorRegulator master) {
        this.master = master;
    }

    synchronized void setPartners(MotorRegulator[] regulators) {
        List<EV3MotorRegulator> checked = new ArrayList<>();
        for (MotorRegulator regulator : regulators) {
            if (regulator == master) {
                throw new IllegalArgumentException("Can't synchronize with self");
            }
            if (!(regulator instanceof EV3MotorRegulator partner)) {
                throw new IllegalArgumentException("Can't synchronize with a motor that has another kind of regulator: "
                        + (regulator == null ? "null" : regulator.getClass().getSimpleName()));
            }
            checked.add(partner);
        }
        partners = checked;
    }

    synchronized void start() {
        List<EV3MotorRegulator> members = new ArrayList<>();
        members.add(master);
        members.addAll(partners);
        List<MotorSnapshot> states = new ArrayList<>();
        for (EV3MotorRegulator member : members) {
            states.add(member.live());
        }
        for (int i = 0; i < members.size(); i++) {
            members.get(i).freeze(states.get(i));
        }
        block = members;
    }

    void end(boolean immediateReturn) {
        List<EV3MotorRegulator> moved = send();
        if (!immediateReturn) {
            for (EV3MotorRegulator member : moved) {
                member.waitComplete();
            }
        }
    }

    private synchronized List<EV3MotorRegulator> send() {
        List<EV3MotorRegulator> moved = new ArrayList<>();
        List<MoveRequest> requests = new ArrayList<>();
        for (EV3MotorRegulator member : block) {
            MoveRequest request = member.takeRecorded();
            if (request != null) {
                moved.add(member);
                requests.add(request);
            }
        }
        if (!moved.isEmpty()) {
            int[] ports = moved.stream().mapToInt(EV3MotorRegulator::index).toArray();
            EV3MotorRegulator.moveTogether(ports, requests.toArray(new MoveRequest[0]));
        }
        block.forEach(EV3MotorRegulator::thaw);
        block = List.of();
        return moved;
    }
}
