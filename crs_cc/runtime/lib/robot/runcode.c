/* The main of a program in the form of the CRS report, whose own code begins in runcode. */

int runcode();

int main(void)
{
    return runcode();
}
