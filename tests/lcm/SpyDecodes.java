// Decodes an LCM log as lcm-spy does: it finds our types on the class path by their fingerprints.
//   java -cp lcm.jar:gravity_wells_types.jar SpyDecodes.java LOG
import java.io.EOFException;
import lcm.logging.Log;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.LCMTypeDatabase;

class SpyDecodes {
  public static void main(String[] arguments) throws Exception {
    LCMTypeDatabase types = new LCMTypeDatabase();
    Log log = new Log(arguments[0], "r");
    int decoded = 0;
    while (true) {
      Log.Event event;
      try {
        event = log.readNext();
      } catch (EOFException end) {
        break;
      }
      String name = event.channel.substring("WELLS_TEST_".length());
      long fingerprint = new LCMDataInputStream(event.data).readLong();
      Class<?> type = types.getClassByFingerprint(fingerprint);
      if (type == null || !type.getName().equals("gravity_wells." + name)) {
        System.err.println(name + ": lcm-spy takes it for " + type);
        System.exit(1);
      }
      type.getConstructor(java.io.DataInput.class).newInstance(new LCMDataInputStream(event.data));
      ++decoded;
    }
    System.out.println(decoded + " types decoded");
    if (decoded == 0) System.exit(1);
  }
}
