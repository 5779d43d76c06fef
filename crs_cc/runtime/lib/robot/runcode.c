/* The main function of a program in the form of the CRS report, which defines runcode. */

int runcode();

int main(void)
{
    return runcode();
}
