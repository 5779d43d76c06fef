int main(void)
{
    double root = sqrt(2.0);  // warning: implicit declaration of function 'sqrt'
//                ^
    return root > 2;
}
