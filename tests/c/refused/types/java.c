/* The report's own excerpt is Java, not C. */
int main(void)
{
    String SERVER_MACHINE_NAME = "procyon.cis.ksu.edu"; // error: String
    return 0;
}
